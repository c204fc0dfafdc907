#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "machine/port/surroundings.h"
#include "machine/sim/machining_centre.h"
#include "probe/sensor/touch_probe.h"
#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"

namespace g31::cli {

/// The simulated machine with what stands around its tool.
struct Scene {
  std::vector<probe::ProbedPart> parts;                 ///< none with signals from a script
  std::unique_ptr<machine::Surroundings> surroundings;  ///< null: nothing can be touched
  std::unique_ptr<machine::MachiningCentre> machine;
};

/// Builds machine, probe and parts of a set-up.  @returns why a part cannot be made or read, with
/// the place in the sheet
Result<Scene, setup::SetupError> build_scene(const setup::Job& job, std::uint64_t seed);

}  // namespace g31::cli

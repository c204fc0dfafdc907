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

/// The parts of a set-up where they stand; none with signals from a script.  @returns why a part
/// cannot be made or read, with the place in the sheet
Result<std::vector<probe::ProbedPart>, setup::SetupError> build_parts(const setup::Job& job);

/// What a machine of the set-up meets among parts that are made already; null: nothing.
/// @param parts  for the balls of the set-up; may be null where no probe is
std::unique_ptr<machine::Surroundings> surroundings_of(
    const setup::Job& job, std::shared_ptr<const probe::TouchableParts> parts, std::uint64_t seed);

/// Builds machine, probe and parts of a set-up.  @returns why a part cannot be made or read, with
/// the place in the sheet
Result<Scene, setup::SetupError> build_scene(const setup::Job& job, std::uint64_t seed);

}  // namespace g31::cli

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "machine/port/surroundings.h"
#include "machine/sim/machining_centre.h"
#include "probe/sensor/touch_probe.h"
#include "tools/session/refusal.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The simulated machine with what stands around its tool.
struct World {
  std::vector<probe::ProbedPart> parts;                 ///< none with signals from a script
  std::unique_ptr<machine::Surroundings> surroundings;  ///< null: nothing can be touched
  std::unique_ptr<machine::MachiningCentre> machine;
};

/// The parts of a set-up where they stand; none with signals from a script.  @returns why a part
/// cannot be made or read, with the place in the sheet
Result<std::vector<probe::ProbedPart>, Refusal> build_parts(const setup::Job& job);

/// What a machine of the set-up meets among parts that are made already; null: nothing.
/// @param parts  for the balls of the set-up; may be null where no probe is
std::unique_ptr<machine::Surroundings> surroundings_of(
    const setup::Job& job, std::shared_ptr<const probe::TouchableParts> parts, std::uint64_t seed);

/// Builds machine, probe and parts of a set-up.  @returns why a part cannot be made or read, with
/// the place in the sheet
Result<World, Refusal> build_world(const setup::Job& job, std::uint64_t seed);

}  // namespace g31::session

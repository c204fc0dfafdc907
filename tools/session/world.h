#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/time_budget.h"
#include "interpreter/source/diagnostic.h"
#include "machine/base/result.h"
#include "machine/port/surroundings.h"
#include "machine/sim/machining_centre.h"
#include "probe/sensor/displacement_sensors.h"
#include "probe/sensor/touch_probe.h"
#include "tools/session/refusal.h"
#include "tools/session/sensed_parts.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The simulated machine with what stands around its tool.
struct World {
  std::vector<source::Diagnostic> findings;  ///< what is wrong before the start: PRB511 to PRB521
  std::vector<probe::ProbedPart> parts;      ///< none where nothing senses them
  std::vector<probe::ProbedPart> beams;      ///< of lasers that measure tools: drawn, not met
  std::unique_ptr<machine::Surroundings> surroundings;  ///< null: nothing can be touched
  std::unique_ptr<machine::MachiningCentre> machine;
};

/// The parts of a set-up where they stand, and what is wrong with their meshes.
struct BuiltParts {
  std::vector<probe::ProbedPart> parts;
  std::vector<source::Diagnostic>
      findings;  ///< PRB511 to PRB516, PRB518, PRB520 and PRB521, by parts
};

/// The parts of a set-up; none where signals come from a script and no sensor is.
/// @returns why a part cannot be made or read, with the place in the sheet
/// @param time  the work ends once it is up or interrupted; null: there is no end
Result<BuiltParts, Refusal> build_parts(const setup::Job& job,
                                        const runtime::TimeBudget* time = nullptr);

/// What a machine of the set-up meets among parts that are made already; null: nothing.
/// @param parts  for the probe and the sensors of the set-up
std::unique_ptr<machine::Surroundings> surroundings_of(const setup::Job& job,
                                                       const SensedParts& parts,
                                                       std::uint64_t seed);

/// PRB519: comments of the sheets that look like variables.
std::vector<source::Diagnostic> lost_variables(const setup::Job& job);

/// PRB517: the part that the ball of a machine of the set-up stands in before the start.
std::optional<source::Diagnostic> start_inside(const setup::Job& job,
                                               const machine::MachiningCentre& machine);

/// Builds machine, probe and parts of a set-up.  @returns why a part cannot be made or read, with
/// the place in the sheet
/// @param time  as there; the machine looks at it in its work, too; outlives the world
/// @param made  the parts of the set-up where they are made already; null: they are not
Result<World, Refusal> build_world(const setup::Job& job, std::uint64_t seed,
                                   runtime::TimeBudget* time = nullptr,
                                   const BuiltParts* made = nullptr);

}  // namespace g31::session

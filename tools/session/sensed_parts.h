#pragma once

#include <memory>
#include <vector>

#include "interpreter/runtime/time_budget.h"
#include "machine/base/result.h"
#include "probe/sensor/displacement_sensors.h"
#include "probe/sensor/touchable_parts.h"
#include "tools/session/carried_parts.h"
#include "tools/session/refusal.h"
#include "tools/session/tool_sets.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The parts of a set-up, ready for what senses them.
struct SensedParts {
  std::shared_ptr<const probe::TouchableParts> by_balls;  ///< null without a probe
  /// For the probe of the second spindle; null: there is none.
  std::shared_ptr<const probe::TouchableParts> by_second;
  std::shared_ptr<const probe::SeenParts> by_sensors;  ///< null without sensors
  std::shared_ptr<const ToolParts> by_tools;           ///< null where the sheet names no tools
  std::vector<CarriedParts> carried;  ///< what of all that does not go along with the table
};
/// @returns why it took too long
/// @param time  as there
Result<SensedParts, Refusal> sensed_parts(const setup::Job& job,
                                          const std::vector<probe::ProbedPart>& parts,
                                          const runtime::TimeBudget* time = nullptr);

}  // namespace g31::session

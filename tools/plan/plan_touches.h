#pragma once

#include <optional>

#include "machine/base/result.h"
#include "probe/planning/inspection_plan.h"
#include "tools/plan/planned_part.h"
#include "tools/session/refusal.h"
#include "tools/session/world.h"
#include "tools/setup/job.h"

namespace g31::plan {

/// The touches of a part as the probe of a set-up reaches them.
struct PlannedTouches {
  probe::InspectionPlan plan;
  double ball_radius_mm = 0.0;
  double clear_z_P = 0.0;  ///< of the ball's centre: nothing stands so high
};

/// @param job    its last part is the product
/// @param built  the parts of the job
/// @param part  whose features are found
Result<PlannedTouches, session::Refusal> plan_touches(const setup::Job& job,
                                                      const session::BuiltParts& built,
                                                      const PlannedPart& part,
                                                      std::optional<double> tolerance_mm);

}  // namespace g31::plan

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "parts/features/feature.h"
#include "probe/planning/inspection_plan.h"

namespace g31::probe {

/// What is in the way of the ball's centre between two places, product frame; nothing: it is free.
using IsBlocked =
    std::function<std::optional<std::string>(const Point& p_P_from, const Point& p_P_to)>;

/// The holes and bosses of a plan that are measured across in X and Y, with what a cycle for
/// circles needs to know of them.  `by_points` says where such a cycle has no way: touches at
/// different heights, or something between the middle of a hole and the begin of a touch.
/// @param ball_radius_mm  > 0
/// @param clear_z_P       of the ball's centre: it travels freely at this height
std::vector<PlannedRound> round_features(const parts::RecognisedPart& part,
                                         const InspectionPlan& plan, double ball_radius_mm,
                                         double clear_z_P, const IsBlocked& is_blocked);

}  // namespace g31::probe

#pragma once

#include "probe/planning/inspection_plan.h"

namespace g31::plan {

/// Puts the points of a plan into the order of a short way over the part and numbers them so:
/// feature by feature, each with the order of its points that is shortest to where the way goes on.
/// Lengths are those between the starts, seen from above.
void put_in_order(probe::InspectionPlan& plan);

}  // namespace g31::plan

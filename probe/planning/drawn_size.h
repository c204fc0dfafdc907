#pragma once

#include <vector>

#include "parts/features/drawn_dimension.h"
#include "probe/planning/inspection_plan.h"

namespace g31::probe {

/// The dimension that a model states between the faces of two points, or of the cylinder that both
/// are on; null: none.
const parts::DrawnDimension* drawn_between(const std::vector<parts::DrawnDimension>& dimensions,
                                           const PlannedPoint& first, const PlannedPoint& second);

}  // namespace g31::probe

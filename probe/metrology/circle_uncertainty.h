#pragma once

#include <vector>

#include "probe/metrology/circle_model.h"
#include "probe/metrology/circle_ranges.h"

namespace g31::metrology {

/// What a fit was made of.
struct FittedCircle {
  const PlaneSamples& samples;
  const std::vector<CircleTurn>& turns;
  const ReversalWindows& windows;
  const CircleTask& task;
};

/// Adds to the uncertainties of a fit what its residuals do not tell of themselves.
///
/// Form: ways that are not straight make lobes on the circle, the same in both directions.  Those
/// of third to sixth order are fitted beside the model.  What the errors change by, as far as noise
/// does not account for it, is part of their uncertainties; and as the form has lobes of the
/// orders 0, 1 and 2, too, which cannot be told from centre, scale and squareness, the root mean
/// square of the lobes of third and fourth order is part of theirs.  In turn noise is what is left
/// beside the lobes.
/// Friction: what the errors change by when another 10 degrees behind the reversals are left out;
/// what friction leaves behind dies away slowly.
void add_systematic(const FittedCircle& fitted, CircleFit& fit);

}  // namespace g31::metrology

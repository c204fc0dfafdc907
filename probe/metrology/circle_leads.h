#pragma once

#include <vector>

#include "probe/metrology/circle_model.h"
#include "probe/metrology/circle_search.h"
#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// The pieces of a record without the ways that lead into the circle and out of it.
///
/// Such a way, an arc or a line at a tangent, runs near the circle for a while and is no part of
/// it.  What the errors of the machine leave, fitted to the middle of the pieces, tells how far off
/// the circle is; from there the pieces grow by 10 degrees at a time, as far as they are no further
/// off.  Pieces that are nowhere off begin whole.  One whose middle is off goes as a whole.  Where
/// the axes start or stop, more belongs to the circle (`rest_allowances`).
///
/// Accuracy: ends that stay within 2e-5 of the radius beyond what the rest scatters by remain.
/// @param task  as for `fit_circle`, from the circle
std::vector<CircleTurn> without_leads(const PlaneSamples& samples, const FoundCircle& found,
                                      const CircleTask& task);

}  // namespace g31::metrology

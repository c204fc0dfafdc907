#pragma once

#include <span>

#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// How far off their later path servo loops may be behind a start and before a stop, mm.
struct RestAllowances {
  double start = 0.0;
  double stop = 0.0;
};

/// A loop of lag tau that starts from rest on a circle of radius R loses the time tau until it has
/// the speed v, and so it does when it stops; meanwhile it is off the path that it has at speed by
/// up to (v tau)^2 / 2R.  Twice that is allowed, tau taken from the record, up to 0.1 s and
/// 1 percent of the radius.  Where a
/// piece begins or ends at speed nothing is lost and nothing allowed.
/// @param way  angle of each sample of the piece from its first, rad
RestAllowances rest_allowances(const PlaneSamples& samples, const CircleTurn& turn,
                               std::span<const double> way, const Circle& circle);

}  // namespace g31::metrology

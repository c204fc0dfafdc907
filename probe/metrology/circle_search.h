#pragma once

#include <optional>
#include <vector>

#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// A circle and the pieces of a record that run along it.
struct FoundCircle {
  Circle circle;
  std::vector<CircleTurn> turns;
  std::vector<CircleTurn> reach;  ///< the same with all that may belong to them
};

/// The circle that most of a path runs along, whatever else the record holds (ways to it and from
/// it, standstill, single wild samples); nullopt where less than a quarter of the way lies on one.
///
/// A path has errors of form, too, and a circle through the best part of it would leave the rest
/// out.  So bands are tried, 0.5, 1.5 and 5 percent of the radius to either side, that the path is
/// to lie in, and samples within 2, 4 and 10 percent of the circle belong to it.  The narrowest
/// band counts with which the pieces of each direction pass all angles, or three quarters of what
/// they do with the widest, which is how far they reach: the rest of it may be ways to the circle.
/// A wider band than the first needs a piece of half a circle: straight ways come as near.
///
/// Accuracy: good enough to tell what belongs to the circle, about the errors of the path itself.
/// The same samples give the same circle.
std::optional<FoundCircle> find_circle(const PlaneSamples& samples);

}  // namespace g31::metrology

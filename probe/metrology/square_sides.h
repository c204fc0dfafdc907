#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "probe/metrology/plane_samples.h"
#include "probe/metrology/square_path.h"

namespace g31::metrology {

/// Points of a record, evenly spread along its way however fast it was gone.
struct SpreadPoints {
  std::vector<Eigen::Vector2d> at;
  std::vector<std::size_t> samples;  ///< the numbers of their samples
};

/// @param step  mm from point to point, at least
SpreadPoints spread_points(const PlaneSamples& samples, double step);

/// The square that most of the points lie beside: two places where the path goes along Y and two
/// where it goes along X.  Ways to the square and away from it may go along the axes as well.
/// nullopt: there are no two such places.
std::optional<Square> nearest_square(const SpreadPoints& points, double extent,
                                     const SquareRequest& request);

/// From where the points first run along a side to where they last do, half open; all of them where
/// none does.
SampleRange points_along(const SpreadPoints& points, const Square& square);

/// The same to the sample: from where the way turns into the first side to where it turns out of
/// the last one, as far as a rough record tells.
SampleRange samples_from_turn_to_turn(const PlaneSamples& samples, const SpreadPoints& points,
                                      const SampleRange& along);

/// The same to the sample: between two points the way turns into the side, or out of it, where it
/// is nearest to the square.
SampleRange samples_on(const PlaneSamples& samples, const SpreadPoints& points,
                       const SampleRange& along, const Square& square);

/// Whether most of these points lie on the square: of a circle less than half does.
bool follows(const SpreadPoints& points, const SampleRange& along, const Square& square);

/// The square by the mean places of the middle halves of its sides.
Square refined_square(const SpreadPoints& points, const SampleRange& along, const Square& square,
                      const SquareRequest& request);

}  // namespace g31::metrology

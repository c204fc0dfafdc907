#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "machine/base/result.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// A square with its sides along the axes, mm.
struct Square {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double half_side = 0.0;

  /// How far a point is from the square along the ray from the centre, positive outside: Yatsuzaki,
  /// equations 14 to 25.  A point at the centre has no ray: minus half a side.
  [[nodiscard]] double ray_error(const Eigen::Vector2d& p) const;

  /// The way along the square, counter-clockwise from the middle of the +X side, to where the ray
  /// through a point meets it, 0 to 8 half sides.
  [[nodiscard]] double place_of(const Eigen::Vector2d& p) const;
};

/// What is known of a square beside its record.
struct SquareRequest {
  std::optional<double> side;  ///< the whole side, mm, > 0
  std::optional<Eigen::Vector2d> centre;
};

/// Samples of a record, half open.
struct SampleRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct SquareEvaluation {
  Square square;
  SampleRange on_square;  ///< from where the path first runs along a side to where it last does
  /// Distance of the corner from where the path crosses its diagonal, mm, negative inside; from +X
  /// +Y counter-clockwise.  Nothing where the path does not come by.
  std::array<std::optional<double>, 4> corner_error;
};

/// Evaluates a recorded square.
///
/// Side and centre that are not given are those of the middle halves of the sides.  Of several
/// crossings of a diagonal the one furthest from the corner counts; a corner where the path only
/// begins or ends has the error of the sample nearest to it on the diagonal.
/// Accuracy: between samples the path is straight, but for a corner that is sharp between two
/// samples, where the lines before and behind it are prolonged: below a tenth of a micrometre for
/// samples of 1 ms at 3 m/min on an axis that lags by 36 ms.
///
/// Error: what is wrong with the record as a square, one line.
Result<SquareEvaluation, std::string> evaluate_square(const PlaneSamples& samples,
                                                      const SquareRequest& request);

}  // namespace g31::metrology

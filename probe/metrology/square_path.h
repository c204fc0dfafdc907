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
  double resolution = 0.0;  ///< one step of the samples' last digit, mm
};

/// Samples of a record, half open.
struct SampleRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct SquareEvaluation {
  Square square;
  SampleRange on_square;  ///< from where the path first runs along a side to where it last does
  /// Distance of the corner from where the path crosses its diagonal, the ray from the centre, mm,
  /// negative inside; from +X +Y counter-clockwise.  Nothing where the path does not come by.
  std::array<std::optional<double>, 4> corner_error;
  /// How far from there the crossing may be in truth, as the samples beside it lie too far apart:
  /// negative, inwards, where the path is taken as sharp between them, positive where as straight.
  std::array<double, 4> corner_unseen = {};
};

/// Evaluates a recorded square.
///
/// Ways to the square and away from it do not count, neither for its place nor at its corners.
/// Side and centre that are not given are those of the middle halves of the sides.  Of several
/// crossings of a diagonal the one furthest from the corner counts; a corner where the path only
/// begins or ends has the error of the sample nearest to it on the diagonal.
///
/// Between samples the path is straight.  But where it goes straight up to two samples and straight
/// on behind them, the ways before and behind are prolonged until they meet: a chord would cut the
/// corner of a perfect path by up to a third of the way between two samples.  A sample that already
/// lies beside those ways, by more than the samples about it scatter, shows a rounding, and the
/// chord stands.
/// Accuracy: below a tenth of a micrometre for samples of 1 ms at 3 m/min on an axis that lags by
/// 36 ms; else within `corner_unseen`.
///
/// Error: what is wrong with the record as a square, one line.
Result<SquareEvaluation, std::string> evaluate_square(const PlaneSamples& samples,
                                                      const SquareRequest& request);

}  // namespace g31::metrology

#include "probe/metrology/square_path.h"

#include <algorithm>
#include <cmath>

#include "probe/metrology/square_corners.h"
#include "probe/metrology/square_sides.h"

namespace g31::metrology {

double Square::ray_error(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - centre;
  const double widest = q.cwiseAbs().maxCoeff();
  return widest > 0.0 ? q.norm() * (1.0 - half_side / widest) : -half_side;
}

double Square::place_of(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - centre;
  const double a = half_side;
  const double widest = q.cwiseAbs().maxCoeff();
  if (widest == 0.0) {
    return 0.0;
  }
  const Eigen::Vector2d on = q * (a / widest);
  if (q.x() == widest) {
    return on.y() >= 0.0 ? on.y() : 8.0 * a + on.y();
  }
  if (q.y() == widest) {
    return 2.0 * a - on.x();
  }
  return q.x() == -widest ? 4.0 * a - on.y() : 6.0 * a + on.x();
}

Result<SquareEvaluation, std::string> evaluate_square(const PlaneSamples& samples,
                                                      const SquareRequest& request) {
  const auto [x_low, x_high] = std::ranges::minmax_element(samples.x);
  const auto [y_low, y_high] = std::ranges::minmax_element(samples.y);
  const double extent = std::hypot(*x_high - *x_low, *y_high - *y_low);
  if (!(extent > 0.0)) {
    return std::string("the path does not move");
  }
  const SpreadPoints points = spread_points(samples, extent / 1000.0);
  const auto rough = nearest_square(points, extent, request);
  if (!rough) {
    return std::string("the path is not a square along the axes");
  }
  const SampleRange along = points_along(points, *rough);
  if (!follows(points, along, *rough)) {
    return std::string("most of the path does not lie on a square of this side along the axes");
  }
  SquareEvaluation evaluation;
  evaluation.square = refined_square(points, along, *rough, request);
  evaluation.on_square = samples_on(samples, points, along, evaluation.square);
  const CornerRecord record{samples, samples_from_turn_to_turn(samples, points, along),
                            request.resolution};
  for (std::size_t corner = 0; corner < evaluation.corner_error.size(); ++corner) {
    if (const auto crossing = corner_crossing(record, evaluation.square, corner)) {
      evaluation.corner_error.at(corner) = crossing->error;
      evaluation.corner_unseen.at(corner) = crossing->unseen;
    }
  }
  return evaluation;
}

}  // namespace g31::metrology

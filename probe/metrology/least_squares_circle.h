#pragma once

#include <span>

#include <Eigen/Core>

#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// One Gauss-Newton step of the distances of points from a circle.
class CircleStep {
 public:
  explicit CircleStep(const Circle& from) : from_(from) {}

  /// A point at the centre itself has no direction and does not count.
  void add(const Eigen::Vector2d& point, double weight = 1.0);

  /// The circle of smallest weighted squares, to first order; the one before where the points do
  /// not determine it.
  [[nodiscard]] Circle taken() const;

 private:
  Circle from_;
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

/// The circle of least squares through all samples of some turns, each by the angle that it stands
/// for: where the feed is lower samples do not count for more (ISO 230-4, centring).
///
/// Accuracy: to a step below 1e-14 of the radius.
/// @param near  a circle that the turns run along
Circle least_squares_circle(const PlaneSamples& samples, std::span<const CircleTurn> turns,
                            const Circle& near);

}  // namespace g31::metrology

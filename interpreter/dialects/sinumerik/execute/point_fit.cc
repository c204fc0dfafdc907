#include "interpreter/dialects/sinumerik/execute/point_fit.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace g31::sinumerik {
namespace {

/// Area over the square of the longest side of a triangle that counts as a line.
constexpr double kStraight = 1e-9;

bool is_line(const Eigen::Matrix3d& points) {
  const Eigen::Vector3d first = points.col(1) - points.col(0);
  const Eigen::Vector3d second = points.col(2) - points.col(0);
  const double longest =
      std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()});
  return first.cross(second).norm() <= kStraight * longest;
}

}  // namespace

std::optional<PointFit> fitted(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  if (is_line(from) || is_line(to)) {
    return std::nullopt;
  }
  const Eigen::Matrix4d motion = Eigen::umeyama(from, to, false);
  PointFit fit;
  fit.turn = motion.topLeftCorner<3, 3>();
  fit.shift = motion.topRightCorner<3, 1>();
  fit.left_over = ((fit.turn * from).colwise() + fit.shift - to).colwise().norm().sum();
  return fit;
}

}  // namespace g31::sinumerik

#pragma once

#include <optional>

#include <Eigen/Core>

namespace g31::sinumerik {

/// A rigid motion, and how far it leaves the points from where they should come.
struct PointFit {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  double left_over = 0.0;  ///< sum of the distances
};

/// The motion, without mirroring, that brings three points nearest to three others: the sum of the
/// squares of the distances is the least.  nullopt: three of them lie on a line.
/// @param from  one point a column, of any unit
std::optional<PointFit> fitted(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to);

}  // namespace g31::sinumerik

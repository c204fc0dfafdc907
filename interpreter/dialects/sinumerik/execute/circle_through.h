#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

namespace g31::sinumerik {

struct PlaneCircle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/// The circle through three points; of four the mean of the circles through three of them each, so
/// that each point counts alike.  nullopt: three of them lie on a line, fall together or
/// are too far apart for the numbers.
/// @param points  3 or 4, of any unit
std::optional<PlaneCircle> circle_through(std::span<const Eigen::Vector2d> points);

}  // namespace g31::sinumerik

#pragma once

#include <algorithm>
#include <span>

#include <Eigen/Geometry>

#include "machine/units/axis_positions.h"

namespace g31::machine {

/// A point of the way of a tool that does not go quite straight, because the machine is real.
struct Waypoint {
  double fraction = 0.0;  ///< 0..1, rising from 0 to 1: what the answers speak of
  AxisPositions q_M;      ///< true position; equal to the one before where an axis sticks
  /// How the tool is turned there, against the part; where no rotary axis is, not at all.
  Eigen::Quaterniond tilt = Eigen::Quaterniond::Identity();
};

/// Whether anything changes between two points.
inline bool differ(const Waypoint& a, const Waypoint& b) {
  return a.q_M != b.q_M || a.tilt.coeffs() != b.tilt.coeffs();
}

/// How far apart two positions are, mm, linear axes only.
inline double distance_mm(const AxisPositions& q_from, const AxisPositions& q_to) {
  return (linear_axes(q_to) - linear_axes(q_from)).norm();
}

/// The length of a way of straight pieces, mm.
inline double length_of(std::span<const Waypoint> way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length += distance_mm(way[i - 1].q_M, way[i].q_M);
  }
  return length;
}

/// The fraction of a way after some of its length, mm; before the way 0, behind it 1.
inline double fraction_after(std::span<const Waypoint> way, double length) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double piece = distance_mm(way[i - 1].q_M, way[i].q_M);
    if (length <= piece && piece > 0.0) {
      const double part = std::max(0.0, length) / piece;
      return way[i - 1].fraction + part * (way[i].fraction - way[i - 1].fraction);
    }
    length -= piece;
  }
  return 1.0;
}

}  // namespace g31::machine

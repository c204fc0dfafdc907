#pragma once

#include <array>
#include <cstddef>

#include "machine/units/point.h"

namespace g31::probe {

/// A point of a Minkowski difference and the point of the target that it comes from.
struct SimplexPoint {
  Point p = Point::Zero();
  Point p_target = Point::Zero();
};

/// Up to four points, and the shares with which they make the nearest one.
struct Simplex {
  std::array<SimplexPoint, 4> points = {};
  std::array<double, 4> shares = {};
  std::size_t count = 0;

  /// What of the target the nearest point comes from.  @pre reduced
  [[nodiscard]] Point on_target() const {
    Point sum = Point::Zero();
    for (std::size_t i = 0; i < count; ++i) {
      sum += shares[i] * points[i].p_target;
    }
    return sum;
  }
};

/// From the nearest point of the simplex to x; 0 where x is inside.  The simplex keeps the points
/// that the nearest one lies between: vertex, edge or triangle; all four where x is inside.
Point reduce_to_nearest(Simplex& simplex, const Point& x);

}  // namespace g31::probe

#pragma once

#include <limits>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// An axis-aligned box, mm; an empty one until the first point is included.
struct Box {
  Point min = Point::Constant(std::numeric_limits<double>::infinity());
  Point max = Point::Constant(-std::numeric_limits<double>::infinity());

  void include(const Point& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  void include(const Box& box) {
    min = min.cwiseMin(box.min);
    max = max.cwiseMax(box.max);
  }
};

/// Half the surface of a box, mm^2: how likely a random way meets it, up to a factor.
inline double half_surface(const Box& box) {
  const Point size = (box.max - box.min).cwiseMax(0.0);
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

/// The box of each triangle of the mesh, in the order of the triangles.
std::vector<Box> triangle_boxes(const Mesh& mesh);

/// A straight path: the points from + s direction, 0 <= s <= length, mm.
struct Path {
  Point from;
  Point direction;  ///< unit vector
  double length = 0.0;
};

}  // namespace g31::parts

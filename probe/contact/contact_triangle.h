#pragma once

#include <array>
#include <cstddef>

#include "machine/units/point.h"

namespace g31::probe {

/// a x b, each component rounded as if its difference of products were exact to about two units in
/// the last place (Kahan's fused multiply-add form): nearly parallel vectors lose nothing.
Point accurate_cross(const Point& a, const Point& b);

/// Triangles lower than this count as their three edges: their normal would be noise.  A ball of
/// radius r then stands too low by at most (height / 2)^2 / (2 r): 2.5e-11 mm at r = 0.5 mm.
inline constexpr double kSliverHeightMm = 1e-5;

/// One edge of a triangle.
struct ContactEdge {
  Point start;
  Point direction;      ///< unit vector; 0 for a vanishing edge
  double length = 0.0;  ///< mm; 0 for a vanishing edge
};

/// A triangle ready for contact with a ball, mm, in 96 bytes.  Both sides count: the order of the
/// vertices does not matter.
struct ContactTriangle {
  std::array<Point, 3> vertices;
  Point normal;  ///< unit vector; 0 for a sliver

  ContactTriangle(const Point& a, const Point& b, const Point& c);

  [[nodiscard]] bool is_sliver() const { return normal == Point::Zero(); }

  /// From vertex i to i + 1.
  [[nodiscard]] ContactEdge edge(std::size_t i) const;

  /// Whether p, or its foot on the plane, lies inside or on the border.  Never for a sliver.
  [[nodiscard]] bool is_above_or_below(const Point& p) const;
};

/// What of a triangle is nearest to a point.
struct Nearest {
  Point point;            ///< mm, on the triangle
  Point normal;           ///< unit vector from there to the point asked about; if the point lies on
                          ///< the triangle, the triangle's normal (Z for a sliver)
  double distance = 0.0;  ///< mm
};

/// Accuracy: distance within 1e-15 of the coordinates' size.
Nearest nearest_of(const ContactTriangle& triangle, const Point& p);

}  // namespace g31::probe

#include "probe/contact/contact_triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace g31::probe {
namespace {

/// Shorter edges have no direction worth the name; the spheres at their ends cover them.
constexpr double kVanishingEdgeMm = 1e-12;

/// a b - c d
double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error_of_cd = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error_of_cd;
}

Nearest nearest_of_edges(const ContactTriangle& triangle, const Point& p) {
  Nearest nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const ContactEdge edge = triangle.edge(i);
    const double along = (p - edge.start).dot(edge.direction);
    const bool past_end = along >= edge.length;
    const Point point = past_end       ? triangle.vertices[(i + 1) % 3]
                        : along <= 0.0 ? edge.start
                                       : Point(edge.start + along * edge.direction);
    const Point offset = p - point;
    const double distance = offset.norm();
    if (distance < nearest.distance) {
      nearest.distance = distance;
      nearest.point = point;
      nearest.normal = offset;
    }
  }
  if (nearest.distance > 0.0) {
    nearest.normal /= nearest.distance;
  } else {
    nearest.normal = triangle.is_sliver() ? Point(Point::UnitZ()) : triangle.normal;
  }
  return nearest;
}

}  // namespace

Point accurate_cross(const Point& a, const Point& b) {
  return {difference_of_products(a.y(), b.z(), a.z(), b.y()),
          difference_of_products(a.z(), b.x(), a.x(), b.z()),
          difference_of_products(a.x(), b.y(), a.y(), b.x())};
}

ContactTriangle::ContactTriangle(const Point& a, const Point& b, const Point& c)
    : vertices{a, b, c}, normal(Point::Zero()) {
  std::array<Point, 3> sides;
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = vertices[(i + 1) % 3] - vertices[i];
    lengths[i] = sides[i].norm();
  }
  // The two sides that are not the longest one carry the least error into their cross product.
  const auto longest =
      static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
  const Point cross = accurate_cross(sides[(longest + 1) % 3], sides[(longest + 2) % 3]);
  const double twice_area = cross.norm();
  if (lengths[longest] >= kVanishingEdgeMm && twice_area >= kSliverHeightMm * lengths[longest]) {
    normal = cross / twice_area;
  }
}

ContactEdge ContactTriangle::edge(std::size_t i) const {
  const Point side = vertices[(i + 1) % 3] - vertices[i];
  const double length = side.norm();
  if (length < kVanishingEdgeMm) {
    return {vertices[i], Point::Zero(), 0.0};
  }
  return {vertices[i], side / length, length};
}

bool ContactTriangle::is_above_or_below(const Point& p) const {
  if (is_sliver()) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Point side = vertices[(i + 1) % 3] - vertices[i];
    if ((p - vertices[i]).dot(normal.cross(side)) < 0.0) {
      return false;
    }
  }
  return true;
}

Nearest nearest_of(const ContactTriangle& triangle, const Point& p) {
  if (!triangle.is_above_or_below(p)) {
    return nearest_of_edges(triangle, p);
  }
  const double height = (p - triangle.vertices[0]).dot(triangle.normal);
  return {p - height * triangle.normal,
          height < 0.0 ? Point(Point::Zero() - triangle.normal) : triangle.normal,
          std::fabs(height)};
}

}  // namespace g31::probe

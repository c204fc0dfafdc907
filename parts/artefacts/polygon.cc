#include "parts/artefacts/polygon.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g31::parts {
namespace {

/// Corner i, an angle of (2 i + 1) half steps, folded back to the smallest piece of the polygon.
Point2 corner(double radius, std::size_t sides, std::size_t i) {
  const double half_step = std::numbers::pi / static_cast<double>(sides);
  const bool below = 2 * i >= sides;
  const std::size_t upper = below ? sides - 1 - i : i;
  const bool left = sides % 2 == 0 && 4 * upper >= sides;
  const std::size_t right = left ? sides / 2 - 1 - upper : upper;
  const bool steep = sides % 4 == 0 && 8 * right >= sides;
  const std::size_t flat = steep ? sides / 4 - 1 - right : right;
  const double angle = static_cast<double>(2 * flat + 1) * half_step;
  // The quotient first: it is exactly 1 for the corner next to the axis.
  const double along = radius * (std::cos(angle) / std::cos(half_step));
  const double across = radius * (std::sin(angle) / std::cos(half_step));
  const double x = steep ? across : along;
  const double y = steep ? along : across;
  return {left ? -x : x, below ? -y : y};
}

std::optional<std::size_t> sides_for_tangent(double tangent, std::size_t most) {
  // atan of the tangent rather than acos of a quotient: acos loses half its digits near 1, and the
  // sagitta is tiny against the radius.
  const double wanted = 4.0 * std::ceil(std::numbers::pi / std::atan(tangent) / 4.0);
  // Not even a number of sides where the sagitta vanishes against the radius.
  if (!(wanted <= static_cast<double>(most))) {
    return std::nullopt;
  }
  return std::max<std::size_t>(4, static_cast<std::size_t>(wanted));
}

}  // namespace

std::vector<Point2> tangent_polygon(double radius, std::size_t sides) {
  std::vector<Point2> corners;
  corners.reserve(sides);
  for (std::size_t i = 0; i < sides; ++i) {
    corners.push_back(corner(radius, sides, i));
  }
  return corners;
}

std::vector<Point2> rectangle(const Point2& size, double corner_radius, std::size_t corner_sides) {
  const Point2 half = 0.5 * size;
  if (corner_radius == 0.0) {
    return {half, {-half.x(), half.y()}, -half, {half.x(), -half.y()}};
  }
  std::vector<Point2> corners = tangent_polygon(corner_radius, 4 * corner_sides);
  for (Point2& p : corners) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      // A corner of the arc that lies on a straight side is put there exactly.
      const double rest = std::fabs(p[axis]) - corner_radius;
      p[axis] = std::copysign(half[axis] + rest, p[axis]);
    }
  }
  return corners;
}

std::optional<std::size_t> sides_within(double radius, double sagitta, std::size_t most) {
  // Corners stand at radius / cos(pi / sides).
  return sides_for_tangent(std::sqrt(sagitta * (2.0 * radius + sagitta)) / radius, most);
}

std::optional<std::size_t> sphere_sides_within(double radius, double sagitta, std::size_t most) {
  // The farthest corners, at the equator, stand at radius * sqrt(1 + 2 tan^2(pi / sides)).
  return sides_for_tangent(std::sqrt(0.5 * sagitta * (2.0 * radius + sagitta)) / radius, most);
}

}  // namespace g31::parts

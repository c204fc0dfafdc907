#include "interpreter/dialects/sinumerik/execute/circle_through.h"

#include <algorithm>
#include <cmath>

namespace g31::sinumerik {
namespace {

/// Height over base of a triangle that counts as a line.
constexpr double kFlat = 1e-9;

std::optional<PlaneCircle> through_three(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                         const Eigen::Vector2d& c) {
  const Eigen::Vector2d to_b = b - a;
  const Eigen::Vector2d to_c = c - a;
  const double twice_area = to_b.x() * to_c.y() - to_b.y() * to_c.x();
  const double base = std::max({to_b.squaredNorm(), to_c.squaredNorm(), (c - b).squaredNorm()});
  if (std::abs(twice_area) <= kFlat * base) {
    return std::nullopt;
  }
  const Eigen::Vector2d out =
      Eigen::Vector2d(to_c.y() * to_b.squaredNorm() - to_b.y() * to_c.squaredNorm(),
                      to_b.x() * to_c.squaredNorm() - to_c.x() * to_b.squaredNorm()) /
      (2.0 * twice_area);
  const PlaneCircle circle{a + out, out.norm()};
  return std::isfinite(circle.radius) && circle.centre.allFinite() ? std::optional(circle)
                                                                   : std::nullopt;
}

}  // namespace

std::optional<PlaneCircle> circle_through(std::span<const Eigen::Vector2d> points) {
  if (points.size() == 3) {
    return through_three(points[0], points[1], points[2]);
  }
  PlaneCircle mean;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const auto circle = through_three(points[(left_out + 1) % 4], points[(left_out + 2) % 4],
                                      points[(left_out + 3) % 4]);
    if (!circle) {
      return std::nullopt;
    }
    mean.centre += circle->centre / 4.0;
    mean.radius += circle->radius / 4.0;
  }
  return mean;
}

}  // namespace g31::sinumerik

#include "probe/collision/probe_section.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace g31::probe {
namespace {

using Radial = Eigen::Vector2d;  ///< distance from the axis, height

Radial nearest_on_segment(const Radial& a, const Radial& b, const Radial& p) {
  const Radial along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? (p - a).dot(along) / squared : 0.0;
  return a + std::fmin(1.0, std::fmax(0.0, t)) * along;
}

}  // namespace

double reach_of(const ProbeSection& section) {
  const double height = std::max(std::abs(section.z_bottom), std::abs(section.z_top));
  const double radius = std::max(section.radius_bottom, section.radius_top);
  return section.p_S.norm() + std::hypot(height, radius) + section.rounding;
}

Point furthest_of(const ProbeSection& section, const Point& direction) {
  const double across = std::hypot(direction.x(), direction.y());
  const double bottom = section.radius_bottom * across + section.z_bottom * direction.z();
  const double top = section.radius_top * across + section.z_top * direction.z();
  const double radius = bottom > top ? section.radius_bottom : section.radius_top;
  const double z = bottom > top ? section.z_bottom : section.z_top;
  const double scale = across > 0.0 ? radius / across : 0.0;
  return {scale * direction.x(), scale * direction.y(), z};
}

Point nearest_of(const ProbeSection& section, const Point& p) {
  const double across = std::hypot(p.x(), p.y());
  const Radial asked(across, p.z());
  const Radial rim_bottom(section.radius_bottom, section.z_bottom);
  const Radial rim_top(section.radius_top, section.z_top);
  const Radial slope = rim_top - rim_bottom;
  const Radial from_rim = asked - rim_bottom;
  const bool within_side = slope.y() * from_rim.x() - slope.x() * from_rim.y() <= 0.0;
  if (within_side && p.z() >= section.z_bottom && p.z() <= section.z_top) {
    return p;
  }
  const std::array<Radial, 3> candidates = {
      nearest_on_segment(rim_bottom, rim_top, asked),
      nearest_on_segment({0.0, section.z_bottom}, rim_bottom, asked),
      nearest_on_segment({0.0, section.z_top}, rim_top, asked)};
  Radial best = candidates[0];
  for (const Radial& candidate : candidates) {
    if ((candidate - asked).squaredNorm() < (best - asked).squaredNorm()) {
      best = candidate;
    }
  }
  const double scale = across > 0.0 ? best.x() / across : 0.0;
  return {scale * p.x(), scale * p.y(), best.y()};
}

}  // namespace g31::probe

#include "probe/tooling/convex_shape.h"

#include <algorithm>
#include <cmath>

namespace g31::probe {
namespace {

Point furthest(const Blade& blade, const Point& direction) {
  const Blade::Radial asked(blade.direction.dot(direction.head<2>()), direction.z());
  const Blade::Radial best = furthest_of(blade, asked);
  return {best.x() * blade.direction.x(), best.x() * blade.direction.y(), best.y()};
}

Point furthest(const Box& box, const Point& direction) {
  const auto signed_half = [&](int axis) {
    return direction[axis] < 0.0 ? -box.half[axis] : box.half[axis];
  };
  return {signed_half(0), signed_half(1), signed_half(2)};
}

/// As furthest_of(section, direction), for what asks a hundred times a touch: hypot takes longer
/// than all the rest, and coordinates are far from where a square overflows.
Point furthest_upright(const ProbeSection& section, const Point& direction) {
  const double across = std::sqrt(direction.x() * direction.x() + direction.y() * direction.y());
  const double bottom = section.radius_bottom * across + section.z_bottom * direction.z();
  const double top = section.radius_top * across + section.z_top * direction.z();
  const double radius = bottom > top ? section.radius_bottom : section.radius_top;
  const double scale = across > 0.0 ? radius / across : 0.0;
  return {scale * direction.x(), scale * direction.y(),
          bottom > top ? section.z_bottom : section.z_top};
}

Point furthest(const ProbeSection& section, const Point& direction) {
  const bool is_upright = section.turn_S.w() == 1.0;
  Point p = section.p_S;
  p += is_upright
           ? furthest_upright(section, direction)
           : section.turn_S * furthest_upright(section, section.turn_S.conjugate() * direction);
  if (section.rounding > 0.0) {
    p += section.rounding / direction.norm() * direction;
  }
  return p;
}

Point furthest(const InsertPlate& plate, const Point& direction) {
  Point best = plate.p_tip_centre;
  if (const double length = direction.norm(); length > 0.0) {
    best += plate.tip_radius / length * direction;
  }
  for (const Point& end : plate.edge_ends) {
    if (end.dot(direction) > best.dot(direction)) {
      best = end;
    }
  }
  return best;
}

}  // namespace

Blade::Radial furthest_of(const Blade& blade, const Blade::Radial& asked) {
  const Blade::Radial outwards(std::max(0.0, asked.x()), std::min(0.0, asked.y()));
  Blade::Radial best = blade.rounded_centre;
  if (const double length = outwards.norm(); length > 0.0) {
    best += blade.rounded_radius / length * outwards;
  }
  for (const Blade::Radial& corner : blade.corners) {
    if (corner.dot(asked) > best.dot(asked)) {
      best = corner;
    }
  }
  return best;
}

Point furthest_of(const ConvexShape& shape, const Point& direction) {
  return std::visit([&](const auto& one) { return furthest(one, direction); }, shape);
}

}  // namespace g31::probe

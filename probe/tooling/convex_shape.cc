#include "probe/tooling/convex_shape.h"

#include <algorithm>

namespace g31::probe {
namespace {

Point furthest(const Blade& blade, const Point& direction) {
  const Blade::Radial asked(blade.direction.dot(direction.head<2>()), direction.z());
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
  return {best.x() * blade.direction.x(), best.x() * blade.direction.y(), best.y()};
}

Point furthest(const Box& box, const Point& direction) {
  const auto signed_half = [&](int axis) {
    return direction[axis] < 0.0 ? -box.half[axis] : box.half[axis];
  };
  return {signed_half(0), signed_half(1), signed_half(2)};
}

Point furthest(const ProbeSection& section, const Point& direction) {
  const Point local = section.turn_S.conjugate() * direction;
  Point p = section.p_S + section.turn_S * furthest_of(section, local);
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

Point furthest_of(const ConvexShape& shape, const Point& direction) {
  return std::visit([&](const auto& one) { return furthest(one, direction); }, shape);
}

}  // namespace g31::probe

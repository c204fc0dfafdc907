#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "parts/features/feature.h"
#include "parts/features/removed_volume.h"

namespace g31::testing {

/// The faces of upright prisms, written down as they would come from a solid.
class VolumeMaker {
 public:
  /// A cuboid; all of its sides but the open ones are walls of the product.
  VolumeMaker(parts::Box box, const std::vector<parts::Side>& open, double angle_deg = 0.0)
      : box_(std::move(box)) {
    axes_.angle_deg = angle_deg;
    for (int side = 0; side < 6; ++side) {
      add_side(side);
    }
    for (const parts::Side side : open) {
      volume.faces[static_cast<std::size_t>(side)].is_open = true;
    }
    const Point size = box_.max - box_.min;
    volume.volume_mm3 = size.x() * size.y() * size.z();
    enclose();
  }

  void add(parts::RemovedFace face) { volume.faces.push_back(std::move(face)); }

  /// Another wall, product frame.
  void add_wall(const Point& at_P, const Point& normal_P) {
    parts::RemovedFace face;
    face.at_P = at_P;
    face.normal_P = normal_P;
    face.area_mm2 = 1.0;
    face.border_P = {at_P};
    add(face);
  }

  /// An upright cylinder from one angle to another, seen from inside or outside.
  static parts::RemovedFace upright(const Point& axis, double radius, double from_deg,
                                    double to_deg, const parts::Box& heights) {
    parts::RemovedFace face;
    face.surface = parts::FaceSurface::Cylinder;
    face.axis_at_P = axis;
    face.radius_mm = radius;
    constexpr int kPoints = 8;
    for (int i = 0; i <= kPoints; ++i) {
      const double angle =
          (from_deg + (to_deg - from_deg) * i / kPoints) * std::numbers::pi / 180.0;
      const Point out(std::cos(angle), std::sin(angle), 0.0);
      for (const double z : {heights.min.z(), heights.max.z()}) {
        face.border_P.emplace_back(axis.x() + radius * out.x(), axis.y() + radius * out.y(), z);
      }
      face.at_P = face.border_P.back();
      face.at_P.z() = (heights.min.z() + heights.max.z()) / 2;
      face.normal_P = out;
    }
    face.area_mm2 = radius * (to_deg - from_deg) * std::numbers::pi / 180.0 *
                    (heights.max.z() - heights.min.z());
    return face;
  }

  parts::RemovedVolume volume;

 private:
  void add_side(int side) {
    const int axis = side / 2;
    const bool is_plus = side % 2 == 0;
    parts::RemovedFace face;
    Point normal = Point::Zero();
    normal[axis] = is_plus ? 1.0 : -1.0;
    Point at = (box_.min + box_.max) / 2;
    at[axis] = is_plus ? box_.max[axis] : box_.min[axis];
    face.at_P = axes_.part_of(at);
    face.normal_P = axes_.part_of(normal);
    face.area_mm2 = 1.0;
    for (int corner = 0; corner < 4; ++corner) {
      Point p = at;
      const int a = (axis + 1) % 3;
      const int b = (axis + 2) % 3;
      p[a] = corner % 2 == 0 ? box_.min[a] : box_.max[a];
      p[b] = corner / 2 == 0 ? box_.min[b] : box_.max[b];
      face.area_mm2 = (box_.max[a] - box_.min[a]) * (box_.max[b] - box_.min[b]);
      face.border_P.push_back(axes_.part_of(p));
    }
    volume.faces.push_back(face);
  }

  void enclose() {
    for (const auto& face : volume.faces) {
      for (const Point& p : face.border_P) {
        volume.box_P.include(p);
      }
    }
  }

  parts::Box box_;
  parts::OwnAxes axes_;
};

}  // namespace g31::testing

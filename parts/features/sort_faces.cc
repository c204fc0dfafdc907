#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "parts/features/outline.h"
#include "parts/features/recognise.h"

namespace g31::parts {
namespace {

using Why = std::optional<std::string>;

struct Heights {
  double lowest;
  double highest;
};

Heights heights_of(const RemovedFace& face) {
  Heights heights{face.at_P.z(), face.at_P.z()};
  for (const Point& p : face.border_P) {
    heights.lowest = std::min(heights.lowest, p.z());
    heights.highest = std::max(heights.highest, p.z());
  }
  return heights;
}

bool is_upright(const Point& axis) {
  return std::hypot(axis.x(), axis.y()) < kSameDirection;
}

/// Whether a cylinder is that of a hole, seen from the volume, and not that of a boss.
bool is_hollow(const RemovedFace& face) {
  const Point from_axis = face.at_P - face.axis_at_P;
  return face.normal_P.dot(from_axis - face.axis_P * face.axis_P.dot(from_axis)) > 0.0;
}

double degrees(double rad) {
  return rad * 180.0 / std::numbers::pi;
}

class FaceSorter {
 public:
  FaceSorter(const RemovedVolume& volume, SeenFrom from, SortedFaces& sorted)
      : volume_(volume), from_(from), sorted_(sorted) {}

  Why take(const RemovedFace& face) {
    if (face.is_open) {
      sorted_.open.push_back(&face);
      return std::nullopt;
    }
    switch (face.surface) {
      case FaceSurface::Plane:
        return take_plane(face);
      case FaceSurface::Cylinder:
        return is_upright(face.axis_P) ? take_upright_cylinder(face) : take_edge(face);
      case FaceSurface::Cone:
      case FaceSurface::Sphere:
      case FaceSurface::Torus:
        return take_edge(face);
      case FaceSurface::Other:
        break;
    }
    return "one of its faces is neither plane nor round";
  }

 private:
  Why take_plane(const RemovedFace& face) {
    const double down = -face.normal_P.z();
    if (std::abs(down) < kSameDirection) {
      sorted_.walls.push_back(&face);
    } else if (is_upright(face.normal_P)) {
      if (down < 0.0) {
        return "material is above it: the probe does not get in from +Z";
      }
      sorted_.floors.push_back(&face);
    } else {
      return take_edge(face);
    }
    return std::nullopt;
  }

  Why take_upright_cylinder(const RemovedFace& face) {
    if (is_hollow(face) != (from_ == SeenFrom::Inside)) {
      return from_ == SeenFrom::Inside ? "a rounded outer corner stands in it"
                                       : "an island stands in it that has hollow walls";
    }
    sorted_.corners.push_back(&face);
    return std::nullopt;
  }

  Why take_edge(const RemovedFace& face) {
    const Heights heights = heights_of(face);
    const bool is_at_top = heights.highest > volume_.box_P.max.z() - kSamePlaceMm;
    const bool is_at_bottom = heights.lowest < volume_.box_P.min.z() + kSamePlaceMm;
    if (face.normal_P.z() > kSameDirection) {
      return "material hangs over it: one of its faces looks down";
    }
    const double from_upright = degrees(std::asin(std::min(1.0, -face.normal_P.z())));
    if (is_at_top && is_at_bottom) {
      return fmt::format("one of its walls is inclined by {:.3g} deg", from_upright);
    }
    if (!is_at_top && !is_at_bottom) {
      return "a face between its upper edge and its floor is neither upright nor level";
    }
    if (face.surface == FaceSurface::Plane && is_ramp(face, heights)) {
      return fmt::format("its floor is inclined by {:.3g} deg", 90.0 - from_upright);
    }
    sorted_.edges.push_back(&face);
    return std::nullopt;
  }

  /// Whether a plane reaches over more than half of the volume.
  [[nodiscard]] bool is_ramp(const RemovedFace& face, const Heights& heights) const {
    const double steepness = std::hypot(face.normal_P.x(), face.normal_P.y());
    const double run = (heights.highest - heights.lowest) * -face.normal_P.z() / steepness;
    const Point size = volume_.box_P.max - volume_.box_P.min;
    constexpr double kShare = 0.51;  // the facets of a drill point reach over half of it
    return run > kShare * std::min(size.x(), size.y());
  }

  const RemovedVolume& volume_;
  SeenFrom from_;
  SortedFaces& sorted_;
};

}  // namespace

Why sort_faces(const RemovedVolume& volume, const SortedFaces::Faces& faces, SeenFrom from,
               SortedFaces& sorted) {
  FaceSorter sorter(volume, from, sorted);
  for (const RemovedFace* face : faces) {
    if (auto why = sorter.take(*face)) {
      return why;
    }
  }
  return std::nullopt;
}

}  // namespace g31::parts

#include "parts/features/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "parts/features/faceted_walls.h"
#include "parts/features/recognise.h"

namespace g31::parts {
namespace {

using Why = std::optional<std::string>;

constexpr std::array<Side, 4> kUprightSides = {Side::XPlus, Side::XMinus, Side::YPlus,
                                               Side::YMinus};
constexpr const char* kNoRectangle = "its outline is no rectangle: it is an L, a T or a cross";

/// The angle of the axes that a wall's normal is parallel to, -45 < angle <= 45.
double angle_of(const Point& normal) {
  constexpr double kQuarter = 90.0;
  constexpr double kPerDegree = 1e10;  // 1e-10 deg are 2e-9 mm in 1 m
  double angle = std::atan2(normal.y(), normal.x()) * 180.0 / std::numbers::pi;
  angle -= kQuarter * std::ceil((angle - kQuarter / 2) / kQuarter - 1e-9);
  return std::round(angle * kPerDegree) / kPerDegree + 0.0;
}

/// The side that a normal shows to best.
Side side_of(const Point& normal_own) {
  return *std::ranges::max_element(kUprightSides, {},
                                   [&](Side side) { return direction_of(side).dot(normal_own); });
}

class OutlineFinder {
 public:
  OutlineFinder(const RemovedVolume& volume, const SortedFaces& sorted, SeenFrom from,
                Outline& outline)
      : volume_(volume),
        sorted_(sorted),
        same_mm_(kSamePlaceMm + kFaceErrorInRoundings * volume.rounding_mm),
        outwards_(from == SeenFrom::Inside ? 1.0 : -1.0),
        outline_(outline) {}

  Why find() {
    for (const auto step : {&OutlineFinder::take_walls, &OutlineFinder::take_open_faces,
                            &OutlineFinder::take_corners}) {
      if (auto why = (this->*step)()) {
        return why;
      }
    }
    for (const Side side : kUprightSides) {
      if (!at(side).is_wall && !at(side).is_open) {
        return fmt::format("it has no upright wall on its {} side", name_of(side));
      }
    }
    return std::nullopt;
  }

 private:
  OutlineSide& at(Side side) { return outline_.sides[static_cast<std::size_t>(side)]; }

  Why take_walls() {
    const auto largest = std::ranges::max_element(
        sorted_.walls, {}, [](const RemovedFace* face) { return face->area_mm2; });
    outline_.axes.angle_deg = angle_of((*largest)->normal_P);
    axes_error_ = direction_error(**largest);
    for (const RemovedFace* wall : sorted_.walls) {
      const Point normal = outwards_ * outline_.axes.own_of(wall->normal_P);
      const Side side = side_of(normal);
      if (!is_at_right_angles(*wall, normal, side)) {
        return "its walls do not stand at right angles to each other";
      }
      if (auto why = close(side, reach(side, wall->at_P), same_mm_)) {
        return why;
      }
    }
    return std::nullopt;
  }

  /// How far out a point is.
  [[nodiscard]] double reach(Side side, const Point& p_P) const {
    return direction_of(side).dot(outline_.axes.own_of(p_P));
  }

  /// By how much the rounding of its corners turns a plane, seen from above, rad.
  [[nodiscard]] double direction_error(const RemovedFace& face) const {
    Box box;
    for (const Point& p : face.border_P) {
      box.include(p);
    }
    const double width = std::hypot(box.max.x() - box.min.x(), box.max.y() - box.min.y());
    constexpr double kBothEnds = 4.0;  // in X and in Y
    return width > 0.0 ? kBothEnds * volume_.rounding_mm / width : 0.0;
  }

  [[nodiscard]] bool is_at_right_angles(const RemovedFace& face, const Point& normal_own,
                                        Side side) const {
    return (normal_own - direction_of(side)).norm() <=
           10.0 * kSameDirection + axes_error_ + direction_error(face);
  }

  Why close(Side side, double how_far, double same_mm) {
    OutlineSide& closed = at(side);
    if (closed.is_wall && std::abs(closed.at - how_far) > same_mm) {
      return kNoRectangle;
    }
    if (!closed.is_wall) {
      closed.at = how_far;
    }
    closed.is_wall = true;
    return std::nullopt;
  }

  Why take_open_faces() {
    for (const RemovedFace* face : sorted_.open) {
      if (std::abs(face->normal_P.z()) > 0.5) {
        continue;  // above or below
      }
      const Point normal = outline_.axes.own_of(face->normal_P);
      const Side side = side_of(normal);
      if (at(side).is_wall) {
        return fmt::format("its {} side is open in part only", name_of(side));
      }
      at(side).is_open = true;
      at(side).is_slanting = at(side).is_slanting || face->surface != FaceSurface::Plane ||
                             !is_at_right_angles(*face, normal, side);
      at(side).at = farthest(side);
    }
    return std::nullopt;
  }

  [[nodiscard]] double farthest(Side side) const {
    double far = -std::numeric_limits<double>::infinity();
    for (const RemovedFace& face : volume_.faces) {
      for (const Point& p : face.border_P) {
        far = std::max(far, reach(side, p));
      }
    }
    return far;
  }

  Why take_corners() {
    for (const RemovedFace* corner : sorted_.corners) {
      int touched = 0;
      const double same_mm = corner->facet_error_mm > 0.0 ? kSameCircleMm : same_mm_;
      for (const Side side : kUprightSides) {
        const double how_far = reach(side, corner->axis_at_P) + corner->radius_mm;
        if (!reaches(*corner, side, how_far - same_mm)) {
          continue;
        }
        ++touched;
        if (at(side).is_open || close(side, how_far, same_mm)) {
          return kNoRectangle;
        }
      }
      if (touched < 2) {
        return "a round wall runs into a straight one at an angle";
      }
      outline_.corner_radius_mm = std::max(outline_.corner_radius_mm, corner->radius_mm);
    }
    return std::nullopt;
  }

  /// Whether the arc of a corner comes to where its circle is farthest out.
  [[nodiscard]] bool reaches(const RemovedFace& corner, Side side, double how_far) const {
    return std::ranges::any_of(corner.border_P,
                               [&](const Point& p) { return reach(side, p) > how_far; });
  }

  const RemovedVolume& volume_;
  const SortedFaces& sorted_;
  double same_mm_;
  double axes_error_ = 0.0;  // rad
  double outwards_;          // of a wall's normal, which shows out of the removed volume
  Outline& outline_;
};

}  // namespace

Point direction_of(Side side) {
  const auto index = static_cast<int>(side);
  Point direction = Point::Zero();
  direction[index / 2] = index % 2 == 0 ? 1.0 : -1.0;
  return direction;
}

Why find_outline(const RemovedVolume& volume, const SortedFaces& sorted, SeenFrom from,
                 Outline& outline) {
  if (sorted.walls.empty()) {
    return sorted.corners.empty() ? "it has no upright walls" : "it is round, but not all round";
  }
  return OutlineFinder(volume, sorted, from, outline).find();
}

}  // namespace g31::parts

#include "parts/features/recognise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <variant>

#include <fmt/format.h>

#include "machine/units/rounded_length.h"
#include "parts/features/outline.h"

namespace g31::parts {
namespace {

using Why = std::optional<std::string>;

Box rounded(const Box& box) {
  Box result;
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] = rounded_length(box.min[axis]);
    result.max[axis] = rounded_length(box.max[axis]);
  }
  return result;
}

/// Finds out what one removed volume is.
class Recogniser {
 public:
  explicit Recogniser(const RemovedVolume& volume) : volume_(volume) {}

  std::variant<Feature, UnknownVolume> result() {
    if (auto why = problem()) {
      return UnknownVolume{rounded(volume_.box_P), *std::move(why)};
    }
    return feature_;
  }

 private:
  Why problem() {
    if (auto why = sort_faces(volume_, sorted_)) {
      return why;
    }
    take_heights();
    if (auto why = is_one_circle() ? take_circle() : take_rectangle()) {
      return why;
    }
    if (!has_open(Side::ZPlus)) {
      return "it is not open towards +Z: the probe does not get in";
    }
    if (feature_.walls_to_z - feature_.walls_from_z < kLeastWallMm) {
      return "it has no upright wall between its chamfers and its floor";
    }
    open(Side::ZPlus);
    if (sorted_.floors.empty() && has_open(Side::ZMinus)) {
      open(Side::ZMinus);
    }
    return take_kind();
  }

  void open(Side side) { feature_.open[static_cast<std::size_t>(side)] = true; }

  [[nodiscard]] bool has_open(Side side) const {
    return std::ranges::any_of(sorted_.open, [side](const RemovedFace* face) {
      return face->normal_P.dot(direction_of(side)) > 0.5;
    });
  }

  void take_heights() {
    feature_.walls_from_z = volume_.box_P.min.z();
    feature_.walls_to_z = volume_.box_P.max.z();
    const double middle = (feature_.walls_from_z + feature_.walls_to_z) / 2;
    for (const RemovedFace* edge : sorted_.edges) {
      Box box;
      for (const Point& p : edge->border_P) {
        box.include(p);
      }
      box.include(edge->at_P);
      if (edge->at_P.z() > middle) {
        feature_.walls_to_z = std::min(feature_.walls_to_z, box.min.z());
      } else {
        feature_.walls_from_z = std::max(feature_.walls_from_z, box.max.z());
        feature_.floor_radius_mm = std::max(feature_.floor_radius_mm, edge->radius_mm);
      }
    }
    feature_.walls_from_z = rounded_length(feature_.walls_from_z);
    feature_.walls_to_z = rounded_length(feature_.walls_to_z);
    feature_.has_flat_floor = !sorted_.floors.empty();
  }

  /// Whether the walls are one hollow cylinder all round.
  [[nodiscard]] bool is_one_circle() const {
    if (!sorted_.walls.empty() || sorted_.corners.empty()) {
      return false;
    }
    const RemovedFace& first = *sorted_.corners.front();
    double area = 0.0;
    for (const RemovedFace* face : sorted_.corners) {
      const Point apart = face->axis_at_P - first.axis_at_P;
      if (std::hypot(apart.x(), apart.y()) > kSamePlaceMm ||
          std::abs(face->radius_mm - first.radius_mm) > kSamePlaceMm) {
        return false;
      }
      area += face->area_mm2;
    }
    constexpr double kShareOfArea = 1e-3;
    const double height = feature_.walls_to_z - feature_.walls_from_z;
    const double whole = 2.0 * std::numbers::pi * first.radius_mm * height;
    return std::abs(area - whole) < kShareOfArea * whole;
  }

  Why take_circle() {
    const RemovedFace& wall = *sorted_.corners.front();
    const Point out(wall.radius_mm, wall.radius_mm, 0.0);
    feature_.is_round = true;
    feature_.own.min = wall.axis_at_P - out;
    feature_.own.max = wall.axis_at_P + out;
    feature_.own.min.z() = volume_.box_P.min.z();
    feature_.own.max.z() = volume_.box_P.max.z();
    feature_.own = feature_.box_P = rounded(feature_.own);
    return std::nullopt;
  }

  Why take_rectangle() {
    Outline outline;
    if (auto why = find_outline(volume_, sorted_, outline)) {
      return why;
    }
    const auto& sides = outline.sides;
    feature_.axes = outline.axes;
    feature_.corner_radius_mm = rounded_length(outline.corner_radius_mm);
    feature_.own.min = {-sides[1].at, -sides[3].at, volume_.box_P.min.z()};
    feature_.own.max = {sides[0].at, sides[2].at, volume_.box_P.max.z()};
    feature_.own = rounded(feature_.own);
    feature_.box_P = outline.axes.angle_deg == 0.0 ? feature_.own : rounded(volume_.box_P);
    for (std::size_t side = 0; side < sides.size(); ++side) {
      feature_.open[side] = sides[side].is_open;
    }
    return fills_its_outline() ? std::nullopt
                               : Why("its outline is no rectangle, or its floor is not level");
  }

  /// Whether the volume is that of its box less the corners; not asked where chamfers, roundings or
  /// slanting ends change it.
  [[nodiscard]] bool fills_its_outline() const {
    if (!sorted_.edges.empty() || feature_.axes.angle_deg != 0.0) {
      return true;
    }
    const Point size = feature_.own.max - feature_.own.min;
    double area = size.x() * size.y();
    for (const RemovedFace* corner : sorted_.corners) {
      const double arc = corner->area_mm2 / (size.z() * corner->radius_mm);  // rad
      area -= corner->radius_mm * corner->radius_mm * (arc * 2.0 / std::numbers::pi) *
              (1.0 - std::numbers::pi / 4.0);
    }
    constexpr double kShare = 1e-6;
    const double whole = area * size.z();
    return std::abs(volume_.volume_mm3 - whole) < kShare * whole + kSamePlaceMm;
  }

  Why take_kind() {
    const auto& open = feature_.open;
    const bool is_open_below = feature_.is_open(Side::ZMinus);
    const auto count = std::count(open.begin(), open.begin() + 4, true);
    if (is_open_below && count > 0) {
      return "it is open below and at a side: it is part of the outline";
    }
    switch (count) {
      case 0:
        feature_.kind =
            feature_.is_round
                ? (is_open_below ? FeatureKind::ThroughHole : FeatureKind::BlindHole)
                : (is_open_below ? FeatureKind::ThroughPocket : FeatureKind::ClosedPocket);
        return std::nullopt;
      case 1:
        feature_.kind = FeatureKind::ClosedSlot;
        return std::nullopt;
      case 2:
        feature_.kind = open[0] == open[1] ? FeatureKind::OpenSlot : FeatureKind::OpenPocket;
        return std::nullopt;
      case 3:
        feature_.kind = FeatureKind::Step;
        return std::nullopt;
      default:
        return "it is open on all four sides: what stands there is a boss, or the stock is higher";
    }
  }

  static constexpr double kLeastWallMm = 1e-3;

  const RemovedVolume& volume_;
  SortedFaces sorted_;
  Feature feature_;
};

auto lower_corner(const Box& box) {
  return std::make_tuple(box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y());
}

}  // namespace

RecognisedPart recognise(const Box& stock_P, const std::vector<RemovedVolume>& volumes) {
  RecognisedPart part;
  part.stock_P = rounded(stock_P);
  for (const RemovedVolume& volume : volumes) {
    auto result = Recogniser(volume).result();
    if (auto* const feature = std::get_if<Feature>(&result)) {
      part.features.push_back(std::move(*feature));
    } else {
      part.unknown.push_back(std::move(std::get<UnknownVolume>(result)));
    }
  }
  const auto box_of = [](const auto& found) { return lower_corner(found.box_P); };
  std::ranges::stable_sort(part.features, {}, box_of);
  std::ranges::stable_sort(part.unknown, {}, box_of);
  return part;
}

}  // namespace g31::parts

#include "parts/features/recognise.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "machine/units/rounded_length.h"
#include "parts/features/islands.h"
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

/// Finds out what goes round in a removed volume: its outline, or an island.
class Recogniser {
 public:
  Recogniser(const RemovedVolume& volume, SeenFrom from) : volume_(volume), from_(from) {}

  /// @param faces  that go round, and for an outline all that is level
  /// @returns why its shape is that of no kind
  Why find_shape(const SortedFaces::Faces& faces) {
    if (auto why = sort_faces(volume_, faces, from_, sorted_)) {
      return why;
    }
    take_heights();
    if (from_ == SeenFrom::Island && sorted_.walls.empty() && sorted_.corners.empty()) {
      return "it has no upright walls";
    }
    if (stands_in_the_open()) {
      return std::nullopt;
    }
    if (auto why = is_one_circle() ? take_circle() : take_rectangle()) {
      return why;
    }
    for (const RemovedFace* corner : sorted_.corners) {
      feature_.facet_error_mm = std::max(feature_.facet_error_mm, corner->facet_error_mm);
    }
    if (feature_.walls_to_z - feature_.walls_from_z < kLeastWallMm) {
      return "it has no upright wall between its chamfers and its floor";
    }
    return std::nullopt;
  }

  /// Names an outline by its open sides.
  /// @param islands  that stand in it, in mm^2 seen from above; nothing: it is not known
  Why find_kind(std::optional<double> islands) {
    if (!has_open(Side::ZPlus)) {
      return "it is not open towards +Z: the probe does not get in";
    }
    if (islands && !fills_its_outline(*islands)) {
      return "its outline is no rectangle, or its floor is not level";
    }
    open(Side::ZPlus);
    if (sorted_.floors.empty() && has_open(Side::ZMinus)) {
      open(Side::ZMinus);
    }
    return take_kind();
  }

  /// What an island is that has a floor around it.
  Feature standing() && {
    feature_.kind = feature_.is_round ? FeatureKind::Boss : FeatureKind::Rib;
    feature_.open.fill(true);
    feature_.open[static_cast<std::size_t>(Side::ZMinus)] = false;
    feature_.has_flat_floor = true;
    return std::move(feature_);
  }

  [[nodiscard]] const Feature& feature() const { return feature_; }

  /// Whether nothing of the product is around it.
  [[nodiscard]] bool stands_in_the_open() const {
    return from_ == SeenFrom::Inside && sorted_.walls.empty() && sorted_.corners.empty() &&
           has_open(Side::ZPlus) && has_open(Side::XPlus) && has_open(Side::XMinus) &&
           has_open(Side::YPlus) && has_open(Side::YMinus);
  }

  /// How much of the plane it takes, mm^2; nothing: chamfers, roundings or slanting ends change it.
  [[nodiscard]] std::optional<double> footprint() const {
    const bool has_slanting_ends =
        std::ranges::find(feature_.slanting, true) != feature_.slanting.end();
    if (!sorted_.edges.empty() || has_slanting_ends) {
      return std::nullopt;
    }
    const Point size = feature_.own.max - feature_.own.min;
    double area = size.x() * size.y();
    for (const RemovedFace* corner : sorted_.corners) {
      const double arc = corner->area_mm2 / (size.z() * corner->radius_mm);  // rad
      area -= corner->radius_mm * corner->radius_mm * (arc * 2.0 / std::numbers::pi) *
              (1.0 - std::numbers::pi / 4.0);
    }
    return area;
  }

 private:
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
    if (auto why = find_outline(volume_, sorted_, from_, outline)) {
      return why;
    }
    const auto& sides = outline.sides;
    feature_.axes = outline.axes;
    feature_.corner_radius_mm = rounded_length(outline.corner_radius_mm);
    feature_.own.min = {-sides[1].at, -sides[3].at, volume_.box_P.min.z()};
    feature_.own.max = {sides[0].at, sides[2].at, volume_.box_P.max.z()};
    feature_.own = rounded(feature_.own);
    feature_.box_P = outline.axes.angle_deg == 0.0 ? feature_.own : rounded(box_of_faces());
    for (std::size_t side = 0; side < sides.size(); ++side) {
      feature_.open[side] = sides[side].is_open;
      feature_.slanting[side] = sides[side].is_slanting;
    }
    return std::nullopt;
  }

  [[nodiscard]] Box box_of_faces() const {
    if (from_ == SeenFrom::Inside) {
      return volume_.box_P;
    }
    Box box;
    for (const auto* const faces : {&sorted_.walls, &sorted_.corners, &sorted_.edges}) {
      for (const RemovedFace* face : *faces) {
        for (const Point& p : face->border_P) {
          box.include(p);
        }
      }
    }
    return box;
  }

  /// Whether the product, or what stands in the volume, is a mesh with round walls.
  [[nodiscard]] bool has_facets() const {
    return std::ranges::any_of(volume_.faces,
                               [](const RemovedFace& face) { return face.facet_error_mm > 0.0; });
  }

  /// Whether the volume is that of its box less the corners and what stands in it.
  [[nodiscard]] bool fills_its_outline(double islands_mm2) const {
    const auto area = footprint();
    if (!area || feature_.is_round) {
      return true;
    }
    // Facets cut corners: 30 deg wide ones 5 percent of a hole.
    const double share = has_facets() ? 0.05 : 1e-6;
    const Point size = feature_.own.max - feature_.own.min;
    const double whole = (*area - islands_mm2) * size.z();
    const double surface = 2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    const double rounding = kFaceErrorInRoundings * volume_.rounding_mm * surface;
    return std::abs(volume_.volume_mm3 - whole) < share * whole + kSamePlaceMm + rounding;
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
  SeenFrom from_;
  SortedFaces sorted_;
  Feature feature_;
};

/// What one removed volume is, and what stands in it.
struct Found {
  std::vector<Feature> features;
  Why problem;  ///< of the volume itself
};

Found found_in(const RemovedVolume& volume) {
  Found found;
  if (volume.is_beside) {
    found.problem = "the stock is wider than the part there: the part's sides are not measured";
    return found;
  }
  const FacesAround faces = faces_around(volume);
  Recogniser outline(volume, SeenFrom::Inside);
  found.problem = outline.find_shape(faces.outer);
  std::optional<double> islands_mm2 = 0.0;
  Why odd_island;
  for (const auto& around : faces.islands) {
    Recogniser island(volume, SeenFrom::Island);
    auto why = island.find_shape(around);
    if (!why && !outline.feature().has_flat_floor) {
      why = "no floor is around it";
    }
    if (why) {
      odd_island = "an island stands in it that is no boss and no rib: " + *why;
      continue;
    }
    const auto footprint = island.footprint();
    islands_mm2 =
        islands_mm2 && footprint ? std::optional(*islands_mm2 + *footprint) : std::nullopt;
    found.features.push_back(std::move(island).standing());
  }
  if (!found.problem && odd_island) {
    found.problem = odd_island;
  }
  if (!found.problem && outline.stands_in_the_open()) {
    if (found.features.empty()) {
      found.problem = "it has no upright walls: the stock is higher there";
    }
    return found;
  }
  if (found.problem) {
    return found;
  }
  found.problem = outline.find_kind(islands_mm2);
  if (!found.problem) {
    found.features.push_back(outline.feature());
  }
  return found;
}

auto lower_corner(const Box& box) {
  return std::make_tuple(box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y());
}

}  // namespace

RecognisedPart recognise(const Box& stock_P, const std::vector<RemovedVolume>& volumes) {
  RecognisedPart part;
  part.stock_P = rounded(stock_P);
  for (const RemovedVolume& volume : volumes) {
    part.face_error_mm = std::max(part.face_error_mm, kFaceErrorInRoundings * volume.rounding_mm);
    Found found = found_in(volume);
    std::ranges::move(found.features, std::back_inserter(part.features));
    if (found.problem) {
      part.unknown.push_back({rounded(volume.box_P), *std::move(found.problem)});
    }
  }
  const auto box_of = [](const auto& found) { return lower_corner(found.box_P); };
  std::ranges::stable_sort(part.features, {}, box_of);
  std::ranges::stable_sort(part.unknown, {}, box_of);
  return part;
}

}  // namespace g31::parts

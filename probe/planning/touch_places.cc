#include "probe/planning/touch_places.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace g31::probe {
namespace {

using parts::Side;

/// Of a ball from what it must not touch.
constexpr double kFreeMm = 0.5;
/// A feature that is as large as a limit may be less by the rounding of its coordinates.
constexpr double kRoundingMm = 1e-6;
constexpr int kSteps = 4;  // to each side of the wanted place

int axis_of(Side side) {
  return static_cast<int>(side) / 2;
}

bool is_plus(Side side) {
  return static_cast<int>(side) % 2 == 0;
}

Point outwards(Side side) {
  Point direction = Point::Zero();
  direction[axis_of(side)] = is_plus(side) ? 1.0 : -1.0;
  return direction;
}

struct Range {
  Range(double lower, double upper) : from(lower), to(upper) {
    if (from > to && from <= to + kRoundingMm) {
      from = to = (from + to) / 2;
    }
  }

  double from;
  double to;

  [[nodiscard]] bool is_empty() const { return !(from <= to); }
  [[nodiscard]] double nearest(double value) const { return std::clamp(value, from, to); }
};

/// The wanted value, then others of the range, near ones first.
std::vector<double> values_of(const Range& range, double wanted) {
  if (range.is_empty()) {
    return {};
  }
  const double first = range.nearest(wanted);
  std::vector<double> values = {first};
  for (int i = 1; i <= kSteps; ++i) {
    for (const double end : {range.to, range.from}) {
      const double value = first + (end - first) * i / kSteps;
      if (value != first) {
        values.push_back(value);
      }
    }
  }
  return values;
}

/// Places of a face that is at right angles to an own axis.
class PlacesOnFace {
 public:
  PlacesOnFace(const PlacedOn& on, Point normal_own, double approach)
      : on_(on), normal_own_(std::move(normal_own)), approach_(approach) {}

  void add(const Point& at_own) {
    const auto& axes = on_.feature.axes;
    PlannedPoint point;
    point.at_P = axes.part_of(at_own);
    point.normal_P = axes.part_of(normal_own_);
    point.start_P = axes.part_of(at_own + (on_.ball_radius_mm + approach_) * normal_own_);
    places_.push_back(std::move(point));
  }

  /// The nearest to the first one first.
  std::vector<PlannedPoint> places() && {
    if (!places_.empty()) {
      const Point wanted = places_.front().at_P;
      std::ranges::stable_sort(places_, {}, [&wanted](const PlannedPoint& point) {
        return (point.at_P - wanted).squaredNorm();
      });
    }
    return std::move(places_);
  }

 private:
  const PlacedOn& on_;
  Point normal_own_;
  double approach_;
  std::vector<PlannedPoint> places_;
};

/// Of a side: the axis that runs along it.
int across_of(Side side) {
  return 1 - axis_of(side);
}

double middle_of(const parts::Box& box, int axis) {
  return (box.min[axis] + box.max[axis]) / 2;
}

/// Where along a side its face is plane and the ball stays clear of the walls beside it.
Range across_range(const PlacedOn& on, Side side) {
  const parts::Feature& feature = on.feature;
  const int across = across_of(side);
  const double middle = middle_of(feature.own, across);
  const double margin = feature.is_standing()
                            ? feature.corner_radius_mm + kFreeMm
                            : std::max(feature.corner_radius_mm, on.ball_radius_mm + kFreeMm);
  const Range range{feature.own.min[across] + margin, feature.own.max[across] - margin};
  return feature.is_round || range.is_empty() ? Range{middle, middle} : range;
}

/// Why a wall is touched nowhere.
std::string too_low(const PlacedOn& on) {
  return fmt::format(
      "the ball of {:g} mm stays {:g} mm above the floor, so it touches a wall {:.6g} mm above it; "
      "its walls go up to {:.6g} mm",
      2.0 * on.ball_radius_mm, kFreeMm, on.ball_radius_mm + kFreeMm,
      on.feature.walls_to_z - on.feature.own.min.z());
}

/// A face at a side of a feature, own axes.
struct SideFace {
  Side side;
  double at;  ///< along the side's axis
  Point normal;
  double approach;  ///< of the ball
  Range heights;
  double wanted_z;
};

TouchPlaces side_places(const PlacedOn& on, const SideFace& face) {
  if (face.heights.is_empty()) {
    return {{}, too_low(on)};
  }
  const int across = across_of(face.side);
  PlacesOnFace places(on, face.normal, face.approach);
  for (const double z : values_of(face.heights, face.wanted_z)) {
    for (const double a :
         values_of(across_range(on, face.side), middle_of(on.feature.own, across))) {
      Point at(0.0, 0.0, z);
      at[axis_of(face.side)] = face.at;
      at[across] = a;
      places.add(at);
    }
  }
  return {std::move(places).places(), ""};
}

double at_side(const parts::Box& box, Side side) {
  return is_plus(side) ? box.max[axis_of(side)] : box.min[axis_of(side)];
}

/// The lowest touch of a wall, at which the ball stays clear of a floor.
double least_z_of(const PlacedOn& on) {
  const parts::Feature& feature = on.feature;
  return feature.is_open(Side::ZMinus)
             ? feature.walls_from_z
             : std::max(feature.walls_from_z, feature.own.min.z() + on.ball_radius_mm + kFreeMm);
}

/// Of a standing feature, from outside; where there is not room enough, from nearer.
TouchPlaces standing_wall_places(const PlacedOn& on, Side side) {
  const parts::Feature& feature = on.feature;
  constexpr double kNearMm = 1.0;
  TouchPlaces all;
  for (const double approach : {on.distances.approach, kNearMm}) {
    const auto places = side_places(on, {side,
                                         at_side(feature.own, side),
                                         outwards(side),
                                         approach,
                                         {least_z_of(on), feature.walls_to_z},
                                         feature.own.max.z() - on.distances.depth});
    all.points.insert(all.points.end(), places.points.begin(), places.points.end());
    all.why_none = places.why_none;
  }
  return all;
}

/// On a level face beside a feature.
/// @param beside  at least, from its side
/// @param is_wanted  whether it may be beside a side
template <typename IsWanted>
TouchPlaces places_beside(const PlacedOn& on, double z, double beside, const IsWanted& is_wanted) {
  constexpr double kFartherMm[] = {0.0, 2.0, 5.0, 10.0, 20.0};
  const parts::Feature& feature = on.feature;
  TouchPlaces all;
  for (const double farther : kFartherMm) {
    for (const Side side : {Side::XMinus, Side::XPlus, Side::YMinus, Side::YPlus}) {
      if (!is_wanted(side)) {
        continue;
      }
      PlacesOnFace places(on, Point::UnitZ(), on.distances.approach_z);
      const double off = beside + farther;
      for (const double a :
           values_of(across_range(on, side), middle_of(on.feature.own, across_of(side)))) {
        Point at(0.0, 0.0, z);
        at[axis_of(side)] = at_side(feature.own, side) + (is_plus(side) ? off : -off);
        at[across_of(side)] = a;
        places.add(at);
      }
      auto found = std::move(places).places();
      all.points.insert(all.points.end(), found.begin(), found.end());
    }
  }
  return all;
}

/// Why no place within the sides of a feature is so far from all of them.
std::string too_narrow(const PlacedOn& on, double inset) {
  const parts::Feature& feature = on.feature;
  const Point size = feature.own.max - feature.own.min;
  const int axis = size.x() <= size.y() ? 0 : 1;
  const char* const name = axis == 0 ? "X" : "Y";
  if (feature.is_standing()) {
    return fmt::format("its top is {:.6g} mm wide in {}; a touch stays {:g} mm off its edges",
                       size[axis], name, inset);
  }
  const std::string rounding =
      feature.floor_radius_mm > 0.0
          ? fmt::format(" and the rounding of {:.6g} mm at its floor", feature.floor_radius_mm)
          : "";
  return fmt::format(
      "the ball of {:g} mm with {:g} mm free on each side{} takes {:.6g} mm; its walls are {:.6g} "
      "mm apart in {}",
      2.0 * on.ball_radius_mm, kFreeMm, rounding, 2.0 * inset, size[axis], name);
}

/// On the level face within the walls of a feature, first in its middle.
/// @param inset  from its walls
TouchPlaces places_within(const PlacedOn& on, double z, double inset) {
  const parts::Feature& feature = on.feature;
  const auto range = [&](int axis) {
    return Range{feature.own.min[axis] + inset, feature.own.max[axis] - inset};
  };
  if (range(0).is_empty() || range(1).is_empty()) {
    return {{}, too_narrow(on, inset)};
  }
  PlacesOnFace places(on, Point::UnitZ(), on.distances.approach_z);
  for (const double x : values_of(range(0), middle_of(feature.own, 0))) {
    for (const double y : values_of(range(1), middle_of(feature.own, 1))) {
      places.add({x, y, z});
    }
  }
  return {std::move(places).places(), ""};
}

}  // namespace

TouchPlaces wall_places(const PlacedOn& on, Side side) {
  const parts::Feature& feature = on.feature;
  if (feature.is_standing()) {
    return standing_wall_places(on, side);
  }
  const int axis = axis_of(side);
  // An open side lets the ball start as far off as it likes; a wall there holds it in the middle.
  const Side facing = static_cast<Side>(static_cast<int>(side) ^ 1);
  const double room = (feature.own.max[axis] - feature.own.min[axis]) / 2 - on.ball_radius_mm;
  const double approach =
      feature.is_open(facing) ? on.distances.approach : std::min(on.distances.approach, room);
  if (approach < kRoundingMm) {
    return {{},
            fmt::format("the ball of {:g} mm does not fit between its walls, which are {:.6g} mm "
                        "apart",
                        2.0 * on.ball_radius_mm, feature.own.max[axis] - feature.own.min[axis])};
  }
  return side_places(on, {side,
                          at_side(feature.own, side),
                          -outwards(side),
                          approach,
                          {least_z_of(on), feature.walls_to_z},
                          feature.own.max.z() - on.distances.depth});
}

TouchPlaces outer_places(const PlacedOn& on, Side side) {
  const double floor = on.feature.own.min.z();
  const double lowest = on.product_P.min.z();
  const double wanted = floor - on.distances.depth;
  return side_places(on, {side,
                          at_side(on.feature.own, side),
                          outwards(side),
                          on.distances.approach,
                          {lowest, floor},
                          wanted < lowest ? (lowest + floor) / 2 : wanted});
}

TouchPlaces floor_places(const PlacedOn& on) {
  const parts::Feature& feature = on.feature;
  const double free = on.ball_radius_mm + kFreeMm + feature.floor_radius_mm;
  return feature.is_standing()
             ? places_beside(on, feature.own.min.z(), free, [](Side /*side*/) { return true; })
             : places_within(on, feature.own.min.z(), free);
}

TouchPlaces top_places(const PlacedOn& on) {
  const parts::Feature& feature = on.feature;
  return feature.is_standing() ? places_within(on, feature.own.max.z(), kFreeMm)
                               : places_beside(on, feature.own.max.z(), on.distances.beside,
                                               [&](Side side) { return !feature.is_open(side); });
}

}  // namespace g31::probe

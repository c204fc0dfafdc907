#include "probe/planning/plan_inspection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "machine/units/rounded_length.h"
#include "probe/planning/drawn_size.h"
#include "probe/planning/touch_places.h"

namespace g31::probe {
namespace {

using parts::Feature;
using parts::Side;

constexpr char kAxisLetters[] = {'X', 'Y', 'Z'};

std::string shown(const Point& p) {
  return fmt::format("X{:.3f} Y{:.3f} Z{:.3f}", p.x() + 0.0, p.y() + 0.0, p.z() + 0.0);
}

/// Plans one feature after the other.
class Planner {
 public:
  Planner(const parts::RecognisedPart& part, const parts::Box& product_P,
          const PlanningOptions& options, const IsUnreachable& unreachable)
      : part_(part), product_P_(product_P), options_(options), unreachable_(unreachable) {}

  InspectionPlan plan() && {
    for (const Feature& feature : part_.features) {
      plan_.features.push_back(
          fmt::format("F{} {}", plan_.features.size() + 1, words_of(feature.kind)));
      add(feature);
    }
    return std::move(plan_);
  }

 private:
  void add(const Feature& feature) {
    const PlacedOn on{feature, product_P_, options_.ball_radius_mm, options_.distances};
    for (const int axis : {0, 1}) {
      add_sideways(on, axis);
    }
    if (!feature.is_open(Side::ZMinus)) {
      add_depth(on);
    }
  }

  [[nodiscard]] std::size_t feature() const { return plan_.features.size() - 1; }

  void leave_out(int axis, std::string why) {
    plan_.left_out.push_back({feature(), kAxisLetters[axis], std::move(why)});
  }

  void add_sideways(const PlacedOn& on, int axis) {
    const auto plus = static_cast<Side>(2 * axis);
    const auto minus = static_cast<Side>(2 * axis + 1);
    // Air is around what stands free, but its walls are its own.
    const bool is_plus_open = on.feature.is_open(plus) && !on.feature.is_standing();
    const bool is_minus_open = on.feature.is_open(minus) && !on.feature.is_standing();
    if (is_plus_open && is_minus_open) {
      return;  // the stock's own size
    }
    if (!is_plus_open && !is_minus_open) {
      add_between(on, axis, wall_places(on, minus), wall_places(on, plus));
      return;
    }
    const Side wall = is_plus_open ? minus : plus;
    const Side open = is_plus_open ? plus : minus;
    if (on.feature.is_slanting(open)) {
      leave_out(axis, "its open side is not at right angles to its walls");
      return;
    }
    add_between(on, axis, wall_places(on, wall), outer_places(on, open));
  }

  void add_depth(const PlacedOn& on) {
    constexpr int kZ = 2;
    if (!on.feature.has_flat_floor) {
      leave_out(kZ, "its floor is not level");
      return;
    }
    add_between(on, kZ, floor_places(on), top_places(on));
  }

  /// A size from the face of the first places to that of the second; a place too where both are
  /// walls that face each other.
  void add_between(const PlacedOn& on, int axis, const TouchPlaces& first_places,
                   const TouchPlaces& second_places) {
    std::string why;
    const auto first = choose(on.feature, first_places, why);
    const auto second = first ? choose(on.feature, second_places, why) : std::nullopt;
    if (!second) {
      leave_out(axis, why);
      return;
    }
    const Point apart = second->at_P - first->at_P;
    const bool has_middle = axis < 2 && first->normal_P.dot(second->normal_P) < 0.0;
    const bool is_from_outside = apart.dot(first->normal_P) < 0.0;
    const Point direction =
        is_from_outside ? Point(Point::Zero() - first->normal_P) : first->normal_P;
    PlannedMeasure size;
    size.id = fmt::format("F{}.{}", feature() + 1, kAxisLetters[axis]);
    size.feature = feature();
    size.axis = kAxisLetters[axis];
    size.direction_P = direction;
    size.nominal = rounded_length(apart.dot(direction));
    size.tolerance = options_.tolerance;
    take_drawn(*first, *second, size);
    size.first = add_point(*first);
    size.second = add_point(*second);
    plan_.measures.push_back(size);
    if (has_middle) {
      add_place(size);
    }
  }

  /// What the model itself says of a size comes first.
  void take_drawn(const PlannedPoint& first, const PlannedPoint& second,
                  PlannedMeasure& size) const {
    const parts::DrawnDimension* const drawn = drawn_between(part_.dimensions, first, second);
    // One that is so far from the faces was not drawn for them.
    constexpr double kNearMm = 1.0;
    if (drawn == nullptr || std::abs(drawn->nominal_mm - size.nominal) > kNearMm) {
      return;
    }
    size.nominal = rounded_length(drawn->nominal_mm);
    if (drawn->lower_mm && drawn->upper_mm) {
      size.tolerance =
          Tolerance{rounded_length(*drawn->lower_mm), rounded_length(*drawn->upper_mm)};
    }
  }

  void add_place(const PlannedMeasure& size) {
    PlannedMeasure place = size;
    const auto middle = (plan_.points[size.first].at_P + plan_.points[size.second].at_P) / 2;
    place.id += ".place";
    place.what = Characteristic::Place;
    place.tolerance = options_.tolerance;
    place.origin_mm = part_.stock_P.min.dot(size.direction_P);
    place.nominal = rounded_length(middle.dot(size.direction_P) - place.origin_mm);
    plan_.measures.push_back(std::move(place));
  }

  std::size_t add_point(PlannedPoint point) {
    point.id = fmt::format("P{}", plan_.points.size() + 1);
    plan_.points.push_back(std::move(point));
    return plan_.points.size() - 1;
  }

  /// @param why  filled where no place is reached
  std::optional<PlannedPoint> choose(const Feature& feature, const TouchPlaces& places,
                                     std::string& why) const {
    // Each facet may be off by twice its sagitta, as a ball in its corner is.
    const bool has_arcs = feature.is_round || feature.corner_radius_mm > 0.0;
    const double of_arcs =
        has_arcs ? std::max(options_.surface_error_mm, 2.0 * feature.facet_error_mm) : 0.0;
    const double error = part_.face_error_mm + of_arcs;
    if (places.points.empty()) {
      why = places.why_none;
      return std::nullopt;
    }
    std::string first_why;
    for (const PlannedPoint& place : places.points) {
      const auto problem = unreachable_(place, error);
      if (!problem) {
        PlannedPoint chosen = place;
        if (!first_why.empty()) {
          chosen.moved = first_why;
        }
        return chosen;
      }
      if (first_why.empty()) {
        first_why = fmt::format("not at {}: {}", shown(place.at_P), *problem);
      }
    }
    why = fmt::format("no place of {} on the face is reached; {}", places.points.size(), first_why);
    return std::nullopt;
  }

  const parts::RecognisedPart& part_;
  const parts::Box& product_P_;
  const PlanningOptions& options_;
  const IsUnreachable& unreachable_;
  InspectionPlan plan_;
};

}  // namespace

InspectionPlan plan_inspection(const parts::RecognisedPart& part, const parts::Box& product_P,
                               const PlanningOptions& options, const IsUnreachable& unreachable) {
  return Planner(part, product_P, options, unreachable).plan();
}

}  // namespace g31::probe

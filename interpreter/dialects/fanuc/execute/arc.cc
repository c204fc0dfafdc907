#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

constexpr double kChordTolerance = 0.01;  // mm, of an end farther away than twice R

/// The axes of a plane: first, second, and the letters of their centre distances.
struct Plane {
  int first;
  int second;
  char first_centre;
  char second_centre;
};

Plane plane_in_force(const Control& control) {
  switch (control.modal.group[2].whole) {
    case 18:
      return {2, 0, 'K', 'I'};
    case 19:
      return {1, 2, 'J', 'K'};
    default:
      return {0, 1, 'I', 'J'};
  }
}

struct Centre {
  double first = 0.0;   ///< mm, from the start point
  double second = 0.0;
};

Failure arc_failure(AlarmId id, std::string detail) {
  Failure failure;
  failure.id = id;
  failure.detail = std::move(detail);
  return failure;
}

/// The centre of an arc given by R: the shorter way round for R > 0, the longer for R < 0 (MB-302).
Result<Centre, Failure> centre_by_radius(double radius, double along, double across, bool clockwise) {
  const double chord = std::hypot(along, across);
  if (chord == 0.0) {
    return arc_failure(AlarmId::ArcRadiusTolerance, "an arc by R needs an end that is not its start");
  }
  const double half = chord / 2.0;
  const double size = std::abs(radius);
  if (half > size + kChordTolerance) {
    return arc_failure(AlarmId::ArcRadiusTolerance,
                       fmt::format("the end is {:.4f} away, more than twice R {:.4f}", chord, size));
  }
  const double height = std::sqrt(std::max(0.0, (size - half) * (size + half)));
  const double side = (clockwise == (radius > 0.0)) ? -1.0 : 1.0;
  return Centre{along / 2.0 - side * height * across / chord,
                across / 2.0 + side * height * along / chord};
}

Result<Centre, Failure> centre_of(const Control& control, const NcBlock& block, const Plane& plane,
                                  const AxisPositions& q_travel) {
  const double along = q_travel[plane.first];
  const double across = q_travel[plane.second];
  if (const EvaluatedWord* const r = block.words.find('R')) {
    const bool clockwise = control.modal.group[1].whole == 2;
    return centre_by_radius(control.scale.length_mm(*r), along, across, clockwise);
  }
  Centre centre;
  const EvaluatedWord* const i = block.words.find(plane.first_centre);
  const EvaluatedWord* const j = block.words.find(plane.second_centre);
  centre.first = i != nullptr ? control.scale.length_mm(*i) : 0.0;
  centre.second = j != nullptr ? control.scale.length_mm(*j) : 0.0;
  const double start_radius = Eigen::Vector2d(centre.first, centre.second).norm();
  const double end_radius = Eigen::Vector2d(along - centre.first, across - centre.second).norm();
  const double tolerance = control.parameters.get(ParameterId::ArcTolerance);
  if (tolerance > 0.0 && std::abs(start_radius - end_radius) > tolerance) {
    return arc_failure(AlarmId::ArcRadiusTolerance,
                       fmt::format("the radius is {:.4f} at the start and {:.4f} at the end",
                                   start_radius, end_radius));
  }
  return centre;
}

/// Neither R nor a centre: alarm 022 with 3403.5 = 1, else a straight line (MB-305).
MaybeFailure arc_without_centre(Control& control, const AxisPositions& q_W_end) {
  if (control.parameters.is_on(ParameterId::ArcNeedsRadius)) {
    return arc_failure(AlarmId::NoCircle, "neither R nor a centre is given");
  }
  if (auto failure = move_to(control, control.coordinates.to_machine(q_W_end),
                             machine::Traverse::Feed, 1)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_W_end);
  return std::nullopt;
}

}  // namespace

/// G02, G03 in the plane in force; a third axis makes a helix (MB-302 to MB-305).
MaybeFailure execute_arc(Control& control, const NcBlock& block) {
  const Plane plane = plane_in_force(control);
  const AxisPositions q_W_end = programmed_end(control, block);
  if (!block.words.has('R') && !block.words.has(plane.first_centre) &&
      !block.words.has(plane.second_centre)) {
    return arc_without_centre(control, q_W_end);
  }
  const AxisPositions q_travel = q_W_end - control.coordinates.programmed();
  const auto centre = centre_of(control, block, plane, q_travel);
  if (!centre) {
    return centre.error();
  }
  const auto feed = feed_in_force(control);
  if (!feed) {
    return feed.error();
  }
  machine::ArcMove move;
  move.q_M_end = control.coordinates.to_machine(q_W_end);
  move.first_axis = plane.first;
  move.second_axis = plane.second;
  const AxisPositions q_M_start = path_position(control);
  move.centre_first = q_M_start[plane.first] + centre.value().first;
  move.centre_second = q_M_start[plane.second] + centre.value().second;
  const int g = control.modal.group[1].whole;
  move.turn = g == 2 ? machine::Turn::Clockwise : machine::Turn::Counterclockwise;
  move.feed_mm_min = feed.value();
  if (auto failure = travel(control, move, g)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_W_end);
  return std::nullopt;
}

}  // namespace g31::fanuc

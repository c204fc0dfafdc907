#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/feed.h"

namespace g31::fanuc {
namespace {

constexpr double kChordTolerance = 0.01;  // mm, of an end farther away than twice R

using machine::Turn;

Eigen::Vector2d in_plane(const AxisPositions& q, const Plane& plane) {
  return {q[plane.first], q[plane.second]};
}

AxisPositions moved_in_plane(const AxisPositions& q, const Plane& plane,
                             const Eigen::Vector2d& to) {
  return path::OffsetPlane{plane.first, plane.second}.moved(q, to);
}

/// An arc behind mirror, scaling and rotation.
struct Arc {
  Plane plane;
  Turn turn;
  AxisPositions q_W_start;
  AxisPositions q_W_end;
};

/// The centre of an arc given by R: the shorter way round for R > 0, the longer for R < 0 (MB-302).
Result<Eigen::Vector2d, Failure> centre_by_radius(const Arc& arc, double radius) {
  const Eigen::Vector2d start = in_plane(arc.q_W_start, arc.plane);
  const Eigen::Vector2d travel = in_plane(arc.q_W_end, arc.plane) - start;
  const double chord = travel.norm();
  const double half = chord / 2.0;
  const double size = std::abs(radius);
  if (half > size + kChordTolerance) {
    return block_failure(
        AlarmId::ArcRadiusTolerance,
        fmt::format("the end is {:.4f} away, more than twice R {:.4f}", chord, size));
  }
  const double height = std::sqrt(std::max(0.0, (size - half) * (size + half)));
  const double side = ((arc.turn == Turn::Clockwise) == (radius > 0.0)) ? -1.0 : 1.0;
  const Eigen::Vector2d left(-travel.y() / chord, travel.x() / chord);
  return Eigen::Vector2d(start + travel / 2.0 + side * height * left);
}

/// The centre of an arc given by I J K, as programmed; both ends must be equally far (MB-303,
/// MB-304).
Result<Eigen::Vector2d, Failure> centre_by_distances(const Control& control, const NcBlock& block,
                                                     const Plane& plane,
                                                     const AxisPositions& q_L_end) {
  const auto distance = [&](char letter) {
    const EvaluatedWord* const word = block.words.find(letter);
    return word != nullptr ? control.scale.length_mm(*word) : 0.0;
  };
  const Eigen::Vector2d from_start(distance(plane.first_centre), distance(plane.second_centre));
  const Eigen::Vector2d centre = in_plane(control.coordinates.programmed(), plane) + from_start;
  const double start_radius = from_start.norm();
  const double end_radius = (in_plane(q_L_end, plane) - centre).norm();
  const double most = control.parameters.get(ParameterId::ArcTolerance);
  if (most > 0.0 && std::abs(start_radius - end_radius) > most) {
    return block_failure(AlarmId::ArcRadiusTolerance,
                         fmt::format("the radius is {:.4f} at the start and {:.4f} at the end",
                                     start_radius, end_radius));
  }
  return centre;
}

/// The centre behind the transform.
Result<Eigen::Vector2d, Failure> centre_of(const Control& control, const NcBlock& block,
                                           const Arc& arc, const AxisPositions& q_L_end) {
  const WorkTransform& transform = control.coordinates.transform();
  if (const EvaluatedWord* const r = block.words.find('R')) {
    const double stretch =
        std::max(transform.stretch(arc.plane.first), transform.stretch(arc.plane.second));
    return centre_by_radius(arc, control.scale.length_mm(*r) * stretch);
  }
  const auto centre = centre_by_distances(control, block, arc.plane, q_L_end);
  if (!centre) {
    return centre.error();
  }
  return in_plane(
      transform.apply(moved_in_plane(control.coordinates.programmed(), arc.plane, centre.value())),
      arc.plane);
}

MaybeFailure straight(Control& control, const AxisPositions& q_L_end, int g) {
  if (auto failure = feed_to(control, control.coordinates.to_path(q_L_end), g)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  return std::nullopt;
}

/// 1730 to 1732: so that the acceleration to the centre is the same on every arc.
/// Source: A-63512EN, page 9.
double feed_on_arc(const Control& control, double feed_mm_min, const Arc& arc,
                   const Eigen::Vector2d& centre) {
  if (control.contour_control() != machine::ContourControl::FeedForward) {
    return feed_mm_min;
  }
  const double most = control.parameters.get(ParameterId::ArcFeed);
  const double of_radius = control.parameters.get(ParameterId::ArcFeedRadius);
  if (!(most > 0.0) || !(of_radius > 0.0)) {
    return feed_mm_min;
  }
  const double least = control.parameters.get(ParameterId::LeastArcFeed);
  const double radius = (in_plane(arc.q_W_start, arc.plane) - centre).norm();
  return std::min(feed_mm_min, std::max(least, most * std::sqrt(radius / of_radius)));
}

/// The arc in path coordinates.
path::ArcShape shape_of(const Control& control, const Arc& arc, const Eigen::Vector2d& centre) {
  const AxisPositions q_B_centre =
      control.coordinates.work_to_path(moved_in_plane(arc.q_W_start, arc.plane, centre));
  return {{q_B_centre[arc.plane.first], q_B_centre[arc.plane.second]}, arc.turn};
}

FeedWay way_of(const Control& control, const Arc& arc, const Eigen::Vector2d& centre) {
  FeedWay way{control.coordinates.work_to_path(arc.q_W_start),
              control.coordinates.work_to_path(arc.q_W_end)};
  way.arc = shape_of(control, arc, centre);
  return way;
}

/// Moves along the arc and tells the observer.
[[gnu::hot]] MaybeFailure move_along(Control& control, const Arc& arc,
                                     const Eigen::Vector2d& centre, double feed_mm_min) {
  path::PathBlock block;
  block.q_M_end = control.coordinates.work_to_path(arc.q_W_end);
  block.arc = shape_of(control, arc, centre);
  block.g = arc.turn == Turn::Clockwise ? 2 : 3;
  block.feed_mm_min = feed_on_arc(control, switched_feed(control, feed_mm_min), arc, centre);
  block.feed_at_contour = control.modal.inverse_time();
  block.where = control.block;
  block.ends = control.feed_end();
  block.contour_control = control.contour_control();
  return travel(control, block);
}

/// Scaled by unequal factors an arc stays an arc, with the radius of its start; a straight piece
/// goes on from there to the end.
MaybeFailure move_unequally_scaled(Control& control, const Arc& arc, const Eigen::Vector2d& centre,
                                   double feed_mm_min) {
  const Eigen::Vector2d to_end = in_plane(arc.q_W_end, arc.plane) - centre;
  const double radius = (in_plane(arc.q_W_start, arc.plane) - centre).norm();
  const double stretched = to_end.norm();
  if (stretched == 0.0 || std::abs(stretched - radius) <= kChordTolerance) {
    return move_along(control, arc, centre, feed_mm_min);
  }
  const Eigen::Vector2d on_arc = centre + to_end * (radius / stretched);
  Arc round = arc;
  round.q_W_end = moved_in_plane(arc.q_W_end, arc.plane, on_arc);
  if (auto failure = move_along(control, round, centre, feed_mm_min)) {
    return failure;
  }
  return line_to(control, control.coordinates.work_to_path(arc.q_W_end), 1, feed_mm_min);
}

/// MELDAS: P of a helix is how many whole turns it goes beside the angle between its ends, which is
/// less than one turn; nothing, where no third axis moves or the arc is given by R.
Result<int, Failure> whole_turns(const Control& control, const NcBlock& block, const Plane& plane) {
  static constexpr int kMostTurns = 9999;
  const EvaluatedWord* const p = block.words.find('P');
  const char across = kAxisLetters[static_cast<std::size_t>(plane.across)];
  if (!control.profile.helix_counts_turns || p == nullptr || !block.words.has(across) ||
      block.words.has('R')) {
    return 0;
  }
  return integer_within(*p, control.profile, [](int turns) {
    return turns < 0 || turns > kMostTurns
               ? MaybeWrong(WrongValue{AlarmId::ValueOutOfRange,
                                       fmt::format("P of a helix is 0 to {} turns", kMostTurns)})
               : std::nullopt;
  });
}

/// The part of a turn from the start of an arc to its end, 0 up to 1.
double part_of_turn(const Arc& arc, const Eigen::Vector2d& centre) {
  constexpr double kSameAngle = 1e-9;
  const Eigen::Vector2d from = in_plane(arc.q_W_start, arc.plane) - centre;
  const Eigen::Vector2d to = in_plane(arc.q_W_end, arc.plane) - centre;
  const double angle = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  const double along = (arc.turn == Turn::Clockwise ? -angle : angle) / (2.0 * std::numbers::pi);
  const double part = along < 0.0 ? along + 1.0 : along;
  return part < kSameAngle || part > 1.0 - kSameAngle ? 0.0 : part;
}

/// A helix of whole turns and what is left to its end, all of one pitch.
MaybeFailure move_in_turns(Control& control, const Arc& arc, const Eigen::Vector2d& centre,
                           int turns, double feed_mm_min) {
  const double rest = part_of_turn(arc, centre);
  const double all = turns + rest;
  const AxisPositions way = arc.q_W_end - arc.q_W_start;
  Arc piece = arc;
  for (int turn = 1; turn <= turns; ++turn) {
    const bool is_last = turn == turns && rest == 0.0;
    piece.q_W_end = is_last ? arc.q_W_end : AxisPositions(arc.q_W_start + turn / all * way);
    piece.q_W_end = moved_in_plane(piece.q_W_end, arc.plane, in_plane(arc.q_W_start, arc.plane));
    if (auto failure = move_along(control, piece, centre, feed_mm_min)) {
      return failure;
    }
    piece.q_W_start = piece.q_W_end;
  }
  piece.q_W_end = arc.q_W_end;
  return rest > 0.0 ? move_along(control, piece, centre, feed_mm_min) : std::nullopt;
}

Turn programmed_turn(const Control& control) {
  return control.modal.group[Group::Motion].whole == 2 ? Turn::Clockwise : Turn::Counterclockwise;
}

/// Why the block's words make no arc in this plane.
MaybeFailure refused_arc(const Control& control, const NcBlock& block, const Plane& plane) {
  if (const EvaluatedWord* const word = block.words.find(plane.across_centre)) {
    return at_word(AlarmId::IllegalPlaneAxis, *word,
                   fmt::format("{} is not of this plane", plane.across_centre));
  }
  if (control.transforms.turns_other_than(plane)) {
    return block_failure(AlarmId::PlaneInRotation);
  }
  return std::nullopt;
}

/// An arc stands still for the machine while it runs: rotary axes may turn the tool, and the plane
/// about its own normal (FANUC A-79348E pp. 23, 24).
MaybeFailure refuse_turning_arc(const Control& control, const AxisPositions& q_L_end) {
  constexpr double kSameDirection = 1e-9;
  const Coordinates& coordinates = control.coordinates;
  if (coordinates.tilts_unled(control.modal.plane().across)) {
    return block_failure(AlarmId::TiltedBySettingError, "an arc in a part that G54.4 tilts");
  }
  if (!coordinates.leader()) {
    return std::nullopt;
  }
  const AxisPositions q_M = control.port.position();
  const AxisPositions q_B_end = coordinates.to_path(q_L_end);
  const bool turns = rotary_axes(q_B_end) != rotary_axes(q_M);
  if (coordinates.tip_system() == TipSystem::None) {
    return turns ? MaybeFailure(
                       block_failure(AlarmId::NotInTiltedPlane, "an arc that turns a rotary axis"))
                 : std::nullopt;
  }
  if (coordinates.tip_system() == TipSystem::Workpiece &&
      (turns || coordinates.table_turn(q_M) != Eigen::Matrix3d::Identity())) {
    return block_failure(AlarmId::NotUnderTipControl,
                         "an arc with the table turned and parameter 19696.5 = 1");
  }
  Point normal = Point::Unit(control.modal.plane().across);
  if (coordinates.plane()) {
    normal = coordinates.plane()->linear() * normal;
  }
  const Point tilts =
      (coordinates.table_turn(q_B_end) - coordinates.table_turn(q_M)).transpose() * normal;
  return tilts.norm() > kSameDirection
             ? MaybeFailure(block_failure(AlarmId::NotUnderTipControl,
                                          "the plane of an arc tilts while it runs"))
             : std::nullopt;
}

/// Neither R nor a centre is given: an alarm, or a line (MB-305).
MaybeFailure without_centre(Control& control, const AxisPositions& q_L_end) {
  if (control.parameters.is_on(ParameterId::ArcNeedsRadius)) {
    return block_failure(AlarmId::NoCircle, "neither R nor a centre is given");
  }
  control.warn(source::DiagnosticId::ArcWithoutCentre, control.block);
  return straight(control, q_L_end, 1);
}

}  // namespace

/// G02, G03 in the plane in force; a third axis makes a helix (MB-302 to MB-305).
[[gnu::hot]] MaybeFailure execute_arc(Control& control, const NcBlock& block) {
  const Plane plane = control.modal.plane();
  if (auto failure = refused_arc(control, block, plane)) {
    return failure;
  }
  const bool by_radius = block.words.has('R');
  const bool has_centre =
      block.words.has(plane.first_centre) || block.words.has(plane.second_centre);
  const AxisPositions q_L_start = control.coordinates.programmed();
  const AxisPositions q_L_end = programmed_end(control, block);
  if (auto failure = refuse_turning_arc(control, q_L_end)) {
    return failure;
  }
  if (!by_radius && !has_centre) {
    return without_centre(control, q_L_end);
  }
  const WorkTransform& transform = control.coordinates.transform();
  Arc arc{plane, programmed_turn(control), transform.apply(q_L_start), transform.apply(q_L_end)};
  if (by_radius && in_plane(q_L_start, plane) == in_plane(q_L_end, plane)) {
    // By R an end that is the start is an arc of no degrees.
    return straight(control, q_L_end, arc.turn == Turn::Clockwise ? 2 : 3);
  }
  if (transform.reverses_turns(plane)) {
    arc.turn = arc.turn == Turn::Clockwise ? Turn::Counterclockwise : Turn::Clockwise;
  }
  const auto centre = centre_of(control, block, arc, q_L_end);
  if (!centre) {
    return centre.error();
  }
  const double first = transform.stretch(plane.first);
  const double second = transform.stretch(plane.second);
  const bool unequal = std::abs(first - second) > 1e-9;
  const auto turns = whole_turns(control, block, plane);
  if (!turns) {
    return turns.error();
  }
  const bool is_one_piece = !unequal && turns.value() == 0;
  if (!is_one_piece && control.cutter.wish.kind != path::CornerWish::Kind::Sharp) {
    return block_failure(AlarmId::ImproperCommand,
                         ",C or ,R at an unequally scaled arc or a helix of several turns");
  }
  if (unequal && turns.value() > 0) {
    return block_failure(AlarmId::ImproperCommand, "a helix of several turns, unequally scaled");
  }
  const auto feed = feed_over(control, [&] { return way_of(control, arc, centre.value()); });
  if (!feed) {
    return feed.error();
  }
  auto failure = unequal ? move_unequally_scaled(control, arc, centre.value(), feed.value())
                 : is_one_piece
                     ? move_along(control, arc, centre.value(), feed.value())
                     : move_in_turns(control, arc, centre.value(), turns.value(), feed.value());
  if (!failure) {
    control.coordinates.arrived_at_programmed(q_L_end);
  }
  return failure;
}

}  // namespace g31::fanuc

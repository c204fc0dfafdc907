#include "interpreter/dialects/sinumerik/execute/travel.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <Eigen/Geometry>

namespace g31::sinumerik {
namespace {

/// How far a chord of a circle that others follow may stand off it.
constexpr double kCoupledChordErrorMm = 1e-3;

using path::PathBlock;
using path::PathItem;
using path::Pause;

MaybeFailure to_machine(Channel& channel, const PathBlock& path) {
  if (const auto halt = channel.watch.before_work()) {
    return halt_failure(*halt);
  }
  if (MaybeFailure outside = out_of_reach(channel, path.q_M_end)) {
    return outside;
  }
  if (path.arc && !is_place(path.arc->centre)) {
    return failure(AlarmId::CircleRadius, "the centre is too far away");
  }
  const Plane plane = channel.plane();
  const auto fault = channel.outlet.move(path, {plane.first, plane.second});
  if (!fault) {
    return std::nullopt;
  }
  Failure reason = from_fault(*fault);
  reason.where = reason.where.value_or(path.where);  // it may have waited for its corner
  return reason;
}

MaybeFailure pause_machine(Channel& channel, const Pause& wait) {
  if (channel.noted_contour) {
    return std::nullopt;
  }
  const auto late = channel.outlet.pause(wait);
  return late ? MaybeFailure(from_fault(*late)) : std::nullopt;
}

AlarmId alarm_of(path::CompensationError error, bool ends) {
  switch (error) {
    case path::CompensationError::ArcAtStartOrEnd:
      return ends ? AlarmId::CompensationEndsOnArc : AlarmId::CompensationStartsOnArc;
    case path::CompensationError::PlaneChanged:
      return AlarmId::PlaneInCompensation;
    case path::CompensationError::StartOrEndWithinArc:
      return ends ? AlarmId::KontEnd : AlarmId::KontStart;
    case path::CompensationError::NoIntersection:
    case path::CompensationError::ArcWithoutRadius:
    case path::CompensationError::Interference:
      break;
  }
  return AlarmId::CompensationCollision;
}

/// What came out of the compensation goes to the machine.
MaybeFailure carry_out(Channel& channel, const path::CompensationResult& result) {
  if (!result) {
    const bool ends = channel.cutter.command.state == path::CompensationCommand::State::Off;
    Failure wrong = failure(alarm_of(result.error().error, ends));
    wrong.where = result.error().where;
    wrong.calls = result.error().calls;
    return wrong;
  }
  for (const PathItem& item : result.value()) {
    if (const auto* const wait = std::get_if<Pause>(&item)) {
      if (MaybeFailure late = pause_machine(channel, *wait)) {
        return late;
      }
      continue;
    }
    const auto& path = std::get<PathBlock>(item);
    if (MaybeFailure late = to_machine(channel, path)) {
      late->where = late->where.value_or(path.where);
      return late;
    }
  }
  return std::nullopt;
}

/// Blocks without motion between two with it: $MC_CUTCOM_MAXNUM_DUMMY_BLOCKS as delivered.
constexpr int kMostIdleBlocks = 3;

MaybeFailure too_idle(const Channel& channel) {
  return channel.cutter.compensation.idle_blocks() > kMostIdleBlocks
             ? MaybeFailure(failure(AlarmId::TooManyIdleBlocks))
             : std::nullopt;
}

/// From the programmed path to that of the tool centre.
MaybeFailure compensate(Channel& channel, const PathBlock& path,
                        const path::CompensationCommand& command) {
  if (channel.noted_contour) {
    return note_way(channel, path);
  }
  path::CutterCompensation& cutter = channel.cutter.compensation;
  if (!cutter.engaged()) {
    return to_machine(channel, path);
  }
  MaybeFailure wrong = carry_out(channel, cutter.take(path, command));
  return wrong ? wrong : too_idle(channel);
}

MaybeFailure compensate_all(Channel& channel, const path::PathItems& items,
                            const path::CompensationCommand& command) {
  for (const PathItem& item : items) {
    if (MaybeFailure wrong = compensate(channel, std::get<PathBlock>(item), command)) {
      return wrong;
    }
  }
  return std::nullopt;
}

Failure cannot_cut(const path::CornerFault& fault) {
  const bool at_arc = fault.error == path::CornerError::ChamferAtArc;
  Failure wrong = failure(AlarmId::NotImplemented,
                          at_arc ? "CHF and CHR at a circle"
                                 : "RND and CHF where another axis moves along with the plane");
  wrong.where = fault.where;
  wrong.calls = fault.calls;
  return wrong;
}

/// Of any length along the end of a path; as it was when the path has no length.
Eigen::Vector3d end_of(const Channel& channel, const AxisPositions& q_P_from,
                       const PathBlock& path) {
  if (!path.arc) {
    const Eigen::Vector3d way = path.q_M_end.head<3>() - q_P_from.head<3>();
    return way.isZero(0.0) ? channel.along_P_end : way;
  }
  const Plane plane = channel.plane();
  const double side = path.arc->turn == machine::Turn::Counterclockwise ? 1.0 : -1.0;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  direction[plane.first] = -side * (path.q_M_end[plane.second] - path.arc->centre.y());
  direction[plane.second] = side * (path.q_M_end[plane.first] - path.arc->centre.x());
  return direction;
}

}  // namespace

Failure from_fault(const machine::MachineFault& fault) {
  const bool lacks_axis = fault.kind == machine::FaultKind::NoAxis;
  Failure reason = failure(lacks_axis ? AlarmId::NoSuchAddress : AlarmId::SoftLimit, fault.what);
  reason.status = lacks_axis ? reason.status : runtime::Status::Collision;
  reason.number = fault.kind == machine::FaultKind::Collision ? -1 : 0;
  if (const source::Location where = path::Outlet::place_of(fault); where.is_known()) {
    reason.where = where;
  }
  return reason;
}

AxisPositions coupled_end(const Channel& channel, const AxisPositions& q_M_from,
                          const AxisPositions& q_M_end) {
  AxisPositions q_M_coupled = q_M_end;
  for (const auto& [axes, factor] : channel.couplings) {
    if (is_machine_axis(axes.first)) {
      q_M_coupled[axes.first] += factor * (q_M_end - q_M_from)[axes.second];
    }
  }
  return q_M_coupled;
}

MaybeFailure travel(Channel& channel, const PathBlock& unled) {
  const AxisPositions q_P_from = channel.path_position();
  PathBlock path = unled;
  path.leads = channel.leads();
  path.calls = unled.calls > 0 ? unled.calls : channel.outlet.calls_now();
  channel.along_P_end = end_of(channel, q_P_from, path);
  CornerStage& corners = channel.corners;
  CutterStage& cutter = channel.cutter;
  cutter.fed = true;
  if (!path.arc && path.q_M_end == q_P_from && cutter.compensation.engaged()) {
    MaybeFailure wrong = carry_out(channel, cutter.compensation.pass(std::nullopt, cutter.command));
    return wrong ? wrong : too_idle(channel);
  }
  if (!corners.contour.holds() && corners.wish.kind == path::CornerWish::Kind::Sharp) {
    return compensate(channel, path, cutter.command);
  }
  const Plane plane = channel.plane();
  const auto given =
      corners.contour.take(path, q_P_from, {plane.first, plane.second}, corners.wish);
  if (!given) {
    return cannot_cut(given.error());
  }
  MaybeFailure wrong = compensate_all(channel, given.value().before, cutter.held_command);
  if (!wrong) {
    wrong = compensate_all(channel, given.value().now, cutter.command);
  }
  cutter.held_command = cutter.command;
  return wrong;
}

namespace {

/// A straight line on which axes go along with others.
MaybeFailure travel_line_coupled(Channel& channel, const PathBlock& path) {
  const AxisPositions q_M_from = channel.machine_position();
  const AxisPositions q_M_end = channel.path_to_machine(path.q_M_end);
  PathBlock coupled = path;
  coupled.q_M_end = channel.machine_to_path(coupled_end(channel, q_M_from, q_M_end));
  if (MaybeFailure wrong = cannot_follow(channel, q_M_end - q_M_from)) {
    return wrong;
  }
  if (MaybeFailure wrong = travel(channel, coupled)) {
    channel.arrived_at_machine();
    return wrong;
  }
  move_followers(channel, q_M_end - q_M_from);
  channel.arrived_at_programmed(channel.path_to_work(coupled.q_M_end), coupled.q_M_end);
  return std::nullopt;
}

/// A circle that axes go along with, in chords.
MaybeFailure travel_circle_coupled(Channel& channel, const PathBlock& path) {
  if (channel.cutter.compensation.engaged() || channel.corners.contour.holds() ||
      channel.corners.wish.kind != path::CornerWish::Kind::Sharp) {
    return failure(AlarmId::NotImplemented,
                   "a circle with G41, G42, RND or CHF while TRAILON "
                   "couples axes");
  }
  const Plane axes = channel.plane();
  const path::OffsetPlane plane{axes.first, axes.second};
  const AxisPositions q_P_from = channel.path_position();
  const path::PlanePoint from = plane.of(q_P_from) - path.arc->centre;
  const double turn = path.arc->turn == machine::Turn::Counterclockwise ? 1.0 : -1.0;
  const double sweep =
      turn * path::sweep_rad({plane.of(q_P_from), plane.of(path.q_M_end), path.arc});
  const int chords = path::chords_of(sweep, from.norm(), kCoupledChordErrorMm);
  AxisPositions q_P_before = q_P_from;
  for (int i = 1; i <= chords; ++i) {
    const double fraction = static_cast<double>(i) / chords;
    AxisPositions q_P = q_P_from + fraction * (path.q_M_end - q_P_from);
    q_P = plane.moved(q_P, path.arc->centre + Eigen::Rotation2Dd(fraction * sweep) * from);
    q_P = i == chords ? path.q_M_end : q_P;
    PathBlock chord = path;
    chord.arc.reset();
    chord.g = 1;
    chord.q_M_end = channel.path_position() + (q_P - q_P_before);
    chord.ends = i == chords ? path.ends : machine::BlockEnd::PassOn;
    if (MaybeFailure wrong = travel_line_coupled(channel, chord)) {
      return wrong;
    }
    q_P_before = q_P;
  }
  return std::nullopt;
}

}  // namespace

MaybeFailure travel_to(Channel& channel, const PathBlock& path, const AxisPositions& q_W_end) {
  if (MaybeFailure wrong = compensate_axes(channel)) {
    return wrong;
  }
  if (!channel.couplings.empty()) {
    return path.arc ? travel_circle_coupled(channel, path) : travel_line_coupled(channel, path);
  }
  if (MaybeFailure wrong = travel(channel, path)) {
    channel.arrived_at_machine();
    return wrong;
  }
  channel.arrived_at_programmed(q_W_end, path.q_M_end);
  return std::nullopt;
}

MaybeFailure pause(Channel& channel, const Pause& wait) {
  CutterStage& cutter = channel.cutter;
  if (MaybeFailure wrong = finish_corners(channel)) {
    return wrong;
  }
  if (!cutter.compensation.engaged()) {
    return pause_machine(channel, wait);
  }
  cutter.fed = true;
  MaybeFailure wrong = carry_out(channel, cutter.compensation.pass(wait, cutter.command));
  return wrong ? wrong : too_idle(channel);
}

MaybeFailure end_compensated_block(Channel& channel) {
  CutterStage& cutter = channel.cutter;
  if (!cutter.compensation.engaged() || cutter.fed) {
    return std::nullopt;
  }
  MaybeFailure wrong = carry_out(channel, cutter.compensation.pass(std::nullopt, cutter.command));
  return wrong ? wrong : too_idle(channel);
}

MaybeFailure finish_corners(Channel& channel) {
  return compensate_all(channel, channel.corners.contour.flush(), channel.cutter.held_command);
}

MaybeFailure finish_motion(Channel& channel) {
  if (channel.is_inspected()) {
    return std::nullopt;
  }
  if (MaybeFailure wrong = line_without_end(channel)) {
    return wrong;
  }
  if (MaybeFailure wrong = finish_corners(channel)) {
    return wrong;
  }
  MaybeFailure wrong = channel.cutter.compensation.engaged()
                           ? carry_out(channel, channel.cutter.compensation.flush())
                           : std::nullopt;
  if (const auto late = channel.outlet.stand_still()) {
    channel.arrived_at_machine();
    return from_fault(*late);
  }
  return wrong;
}

void drop_motion(Channel& channel) {
  channel.corners.contour = CornerStage().contour;
  channel.cutter.compensation.disengage();
  channel.held_line.reset();
  channel.noted_contour.reset();
  channel.arrived_at_machine();
}

MaybeFailure leave_compensation(Channel& channel) {
  if (!channel.cutter.compensation.engaged() && !channel.corners.contour.holds()) {
    return std::nullopt;
  }
  MaybeFailure wrong = finish_motion(channel);
  channel.cutter.compensation.disengage();
  channel.arrived_at_machine();
  return wrong;
}

}  // namespace g31::sinumerik

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/circle_form.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

using Vector3 = Eigen::Vector3d;
using machine::Turn;

/// How far chords may stand off a circle that no plane of the machine's axes holds, mm.
constexpr double kChordErrorMm = 5e-4;

/// A circle or helix in work coordinates, anywhere in space.
struct SpatialArc {
  Vector3 centre = Vector3::Zero();  ///< of the start
  Vector3 out = Vector3::Zero();     ///< from the centre to the start
  Vector3 ahead = Vector3::Zero();   ///< square to it, as long, in the direction of travel
  double sweep = 0.0;
};

/// What all ways of doing a circle need.
struct Job {
  const Block& block;
  AxisPositions q_W_start;
  AxisPositions q_W_end;
};

Result<double, Failure> turns_of(const Block& block) {
  const double turns = block.words[Address::Turns].value;
  auto wrong = wrong_turns(turns);
  return wrong ? Result<double, Failure>(failure(*std::move(wrong))) : turns;
}

/// The other axes go along in proportion: what they are after a part of the way.
AxisPositions along(const Job& job, double fraction) {
  return job.q_W_start + fraction * (job.q_W_end - job.q_W_start);
}

Result<double, Failure> feed_of(Channel& channel, const Job& job, const SpatialArc& arc,
                                double rise_mm) {
  const double arc_mm = arc.out.norm() * arc.sweep;
  FeedWay way = feed_way(channel, job.block, job.q_W_end, std::hypot(arc_mm, rise_mm));
  way.circle = {arc.centre[kTransverseAxis], arc.out[kTransverseAxis], arc.ahead[kTransverseAxis],
                arc.sweep};
  const auto share = helix_share(channel, arc_mm, rise_mm);
  if (!share) {
    return share.error();
  }
  way.share = share.value();
  return feed_in_force(channel, job.block, way);
}

SpatialArc in_space(const Circle& circle, const AxisPositions& q_W_start, double sweep) {
  SpatialArc arc;
  const Plane& plane = circle.plane;
  const PlaneVector out = circle.start - circle.centre;
  const double side = circle.turn == Turn::Counterclockwise ? 1.0 : -1.0;
  arc.centre = q_W_start.head<3>();
  arc.centre[plane.first] = circle.centre.x();
  arc.centre[plane.second] = circle.centre.y();
  arc.out = Vector3::Zero();
  arc.out[plane.first] = out.x();
  arc.out[plane.second] = out.y();
  arc.ahead = Vector3::Zero();
  arc.ahead[plane.first] = -side * out.y();
  arc.ahead[plane.second] = side * out.x();
  arc.sweep = sweep;
  return arc;
}

/// Through three points in space.
Result<SpatialArc, Failure> through(const Vector3& start, const Vector3& middle,
                                    const Vector3& end) {
  const Vector3 a = middle - start;
  const Vector3 b = end - start;
  const Vector3 normal = a.cross(b);
  const double area = normal.norm();
  if (area <= 1e-9 * a.norm() * b.norm()) {
    return failure(AlarmId::BadIntermediatePoint);
  }
  const Vector3 to_centre =
      (a.squaredNorm() * b.cross(normal) + b.squaredNorm() * normal.cross(a)) / (2.0 * area * area);
  SpatialArc arc;
  arc.centre = start + to_centre;
  arc.out = -to_centre;
  arc.ahead = normal.cross(arc.out) / area;
  const Vector3 last = end - arc.centre;
  const double angle = std::atan2(last.dot(arc.ahead), last.dot(arc.out));
  arc.sweep = angle > 0.0 ? angle : angle + kFullRad;
  return arc;
}

bool wants_corner(const Channel& channel) {
  return channel.corners.contour.holds() ||
         channel.corners.wish.kind != path::CornerWish::Kind::Sharp;
}

/// In chords, for a machine whose arcs lie in planes of its axes.
MaybeFailure move_in_chords(Channel& channel, const Job& job, const SpatialArc& arc) {
  if (channel.cutter.compensation.engaged() || wants_corner(channel)) {
    return failure(
        AlarmId::NotImplemented,
        "a circle in a tilted plane, or on which the tool turns, with G41, G42, RND or CHF");
  }
  const double radius = arc.out.norm();
  const Vector3 normal = arc.out.cross(arc.ahead).normalized();
  const double rise = (job.q_W_end - job.q_W_start).head<3>().dot(normal);
  const auto feed = feed_of(channel, job, arc, rise);
  if (!feed) {
    return feed.error();
  }
  int chords = path::chords_of(arc.sweep, radius, kChordErrorMm);
  std::vector<AxisPositions> turned;
  if (has_direction(job.block)) {
    auto ends = pieces_of_turn(channel, channel.to_machine(job.q_W_end), job.q_W_end, chords);
    if (!ends) {
      return ends.error();
    }
    const bool goes_along_circle = ends.value().size() > 1;
    turned = goes_along_circle ? std::move(ends.value()) : turned;
    chords = goes_along_circle ? static_cast<int>(turned.size()) : chords;
  }
  for (int i = 1; i <= chords; ++i) {
    const double fraction = static_cast<double>(i) / chords;
    const double angle = arc.sweep * fraction;
    AxisPositions q_W = along(job, fraction);
    q_W.head<3>() = arc.centre + std::cos(angle) * arc.out + std::sin(angle) * arc.ahead +
                    fraction * rise * normal;
    if (!turned.empty()) {
      q_W.tail<kRotaryAxisCount>() = rotary_axes(turned[static_cast<std::size_t>(i - 1)]);
    }
    q_W = i == chords ? job.q_W_end : q_W;
    path::PathBlock chord;
    chord.q_M_end = channel.to_path(q_W);
    chord.feed_mm_min = feed.value();
    chord.where = job.block.where;
    take_modes(channel, chord);
    chord.ends = i == chords ? chord.ends : machine::BlockEnd::PassOn;
    if (MaybeFailure wrong = travel_to(channel, chord, q_W)) {
      return wrong;
    }
  }
  return std::nullopt;
}

/// As arcs of the machine: full turns first, then the way to the end.
MaybeFailure move_in_arcs(Channel& channel, const Job& job, const Circle& circle, double turns) {
  if (turns > 0.0 && wants_corner(channel)) {
    return failure(AlarmId::NotImplemented, "TURN with RND or CHF");
  }
  const double sweep = sweep_of(circle);
  const double total = sweep + turns * kFullRad;
  const Plane& plane = circle.plane;
  const double rise = job.q_W_end[plane.normal] - job.q_W_start[plane.normal];
  const double arc_mm = (circle.start - circle.centre).norm() * total;
  const auto feed = feed_of(channel, job, in_space(circle, job.q_W_start, total), rise);
  if (!feed) {
    return feed.error();
  }
  AxisPositions q_W_centre = job.q_W_start;
  q_W_centre[plane.first] = circle.centre.x();
  q_W_centre[plane.second] = circle.centre.y();
  const AxisPositions q_P_centre = channel.to_path(q_W_centre);
  const bool clockwise = (circle.turn == Turn::Clockwise) != plane_of_path(channel).is_mirrored;
  path::PathBlock path;
  path.arc = path::ArcShape{{q_P_centre[plane.first], q_P_centre[plane.second]},
                            clockwise ? Turn::Clockwise : Turn::Counterclockwise};
  path.g = clockwise ? 2 : 3;
  // F of a helix is of its way, that of a machine's arc of the plane.
  path.feed_mm_min = feed.value() * (arc_mm / std::hypot(arc_mm, rise));
  path.where = job.block.where;
  take_modes(channel, path);
  const machine::BlockEnd ends = path.ends;
  for (double turn = 1.0; turn <= turns; turn += 1.0) {
    AxisPositions q_W = along(job, turn * kFullRad / total);
    q_W[plane.first] = job.q_W_start[plane.first];
    q_W[plane.second] = job.q_W_start[plane.second];
    path.q_M_end = channel.to_path(q_W);
    path.ends = machine::BlockEnd::PassOn;
    if (MaybeFailure wrong = travel_to(channel, path, q_W)) {
      return wrong;
    }
  }
  path.q_M_end = channel.to_path(job.q_W_end);
  path.ends = ends;
  return travel_to(channel, path, job.q_W_end);
}

MaybeFailure move_in_space(Channel& channel, const Job& job, double turns) {
  const Vector3 middle = middle_of(channel, job.block, job.q_W_start).head<3>();
  const auto once = through(job.q_W_start.head<3>(), middle, job.q_W_end.head<3>());
  if (!once) {
    return once.error();
  }
  SpatialArc arc = once.value();
  arc.sweep += turns * kFullRad;
  return move_in_chords(channel, job, arc);
}

}  // namespace

MaybeFailure move_along_circle(Channel& channel, const Block& block) {
  if (goes_by_axes(channel)) {
    return failure(AlarmId::NotImplemented, "PTP goes with G0 and G1, a circle needs CP");
  }
  const auto q_W_end = programmed_end(channel, block);
  const auto turns = turns_of(block);
  if (!q_W_end || !turns) {
    return !q_W_end ? q_W_end.error() : turns.error();
  }
  Job job{block, channel.present(), q_W_end.value()};
  if (is_spatial(channel, block, job.q_W_start, job.q_W_end)) {
    return move_in_space(channel, job, turns.value());
  }
  const auto circle = programmed_circle(channel, block, job.q_W_end);
  if (!circle) {
    return circle.error();
  }
  if (circle.value().is_straight) {
    return move_straight(channel, block);
  }
  const PlaneOfPath plane = plane_of_path(channel);
  if (!plane.is_even) {
    return failure(AlarmId::NotImplemented, "a circle in an unequally scaled plane");
  }
  const bool tool_turns =
      has_direction(block) && turns_along_circle(channel, channel.to_machine(job.q_W_end));
  if (plane.is_parallel && !tool_turns) {
    return move_in_arcs(channel, job, circle.value(), turns.value());
  }
  const double sweep = sweep_of(circle.value()) + turns.value() * kFullRad;
  return move_in_chords(channel, job, in_space(circle.value(), job.q_W_start, sweep));
}

}  // namespace g31::sinumerik

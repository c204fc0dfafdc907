#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {
namespace {

using Vector = Eigen::Vector2d;
using machine::Turn;

constexpr double kEndTolerance = 0.01;  // mm, as $MC_CIRCLE_ERROR_CONST

constexpr Address kCentre[] = {Address::CentreX, Address::CentreY, Address::CentreZ};
constexpr Address kMiddle[] = {Address::MiddleX, Address::MiddleY, Address::MiddleZ};

/// A circle in its plane, work coordinates.
struct Circle {
  Plane plane;
  Turn turn = Turn::Clockwise;
  Vector start;
  Vector end;
};

Vector left_of(const Vector& v) {
  return {-v.y(), v.x()};
}

/// CR: the shorter way round, negative the longer one.
Result<Vector, Failure> centre_by_radius(const Circle& circle, double radius) {
  const Vector chord = circle.end - circle.start;
  const double half = chord.norm() / 2.0;
  const double size = std::abs(radius);
  if (half == 0.0 || half > size + kEndTolerance) {
    return failure(AlarmId::CircleRadius,
                   fmt::format("CR={:.4f}, half the chord is {:.4f}", radius, half));
  }
  const double height = std::sqrt(std::max(0.0, (size - half) * (size + half)));
  const double side = (circle.turn == Turn::Clockwise) == (radius > 0.0) ? -1.0 : 1.0;
  return Vector(circle.start + chord / 2.0 + side * height * left_of(chord) / (2.0 * half));
}

/// I, J, K from the start; with AC in work coordinates.
Vector centre_by_words(const Channel& channel, const Block& block, const Circle& circle) {
  Vector centre = circle.start;
  const int axes[] = {circle.plane.first, circle.plane.second};
  for (int i = 0; i < 2; ++i) {
    const BlockWords::Word& word = block.words[kCentre[axes[i]]];
    const double value = channel.stored(axes[i], word.value);
    if (word.present) {
      centre[i] = word.modification == Modification::Absolute ? value : centre[i] + value;
    }
  }
  return centre;
}

/// AR and the end: the centre lies left or right of the chord.
Result<Vector, Failure> centre_by_opening(const Circle& circle, double degrees) {
  const Vector chord = circle.end - circle.start;
  if (!(degrees > 0.0 && degrees < 360.0) || chord.norm() == 0.0) {
    return failure(AlarmId::BadOpeningAngle, fmt::format("AR={:.4f}", degrees));
  }
  const double half = degrees / 2.0 * std::numbers::pi / 180.0;
  const double side = circle.turn == Turn::Clockwise ? -1.0 : 1.0;
  return Vector(circle.start + chord / 2.0 +
                side * left_of(chord) / 2.0 * (std::cos(half) / std::sin(half)));
}

/// CIP: the circle through three points, and the way round that meets the middle one.
Result<Vector, Failure> centre_by_middle(const Channel& channel, const Block& block,
                                         Circle& circle) {
  Vector middle = circle.start;
  const int axes[] = {circle.plane.first, circle.plane.second};
  for (int i = 0; i < 2; ++i) {
    const BlockWords::Word& word = block.words[kMiddle[axes[i]]];
    const bool adds = word.modification == Modification::Incremental ||
                      (word.modification == Modification::None && channel.group[14] == 2);
    if (word.present) {
      const double value = channel.stored(axes[i], word.value);
      middle[i] = adds ? middle[i] + value : value;
    }
  }
  const Vector a = middle - circle.start;
  const Vector b = circle.end - circle.start;
  const double cross = a.x() * b.y() - a.y() * b.x();
  if (std::abs(cross) < 1e-9 * a.norm() * b.norm() || a.norm() == 0.0) {
    return failure(AlarmId::BadIntermediatePoint);
  }
  circle.turn = cross < 0.0 ? Turn::Clockwise : Turn::Counterclockwise;
  const Vector offset((b.y() * a.squaredNorm() - a.y() * b.squaredNorm()) / (2.0 * cross),
                      (a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) / (2.0 * cross));
  return Vector(circle.start + offset);
}

Result<Vector, Failure> centre_of(const Channel& channel, const Block& block, Circle& circle) {
  if (channel.group[1] == 5) {
    return centre_by_middle(channel, block, circle);
  }
  if (block.words.has(Address::Radius)) {
    return centre_by_radius(circle, block.words[Address::Radius].value * channel.mm_per_length());
  }
  const bool by_centre =
      block.words.has(kCentre[circle.plane.first]) || block.words.has(kCentre[circle.plane.second]);
  if (block.words.has(Address::OpeningAngle)) {
    return by_centre ? Result<Vector, Failure>(failure(AlarmId::NotImplemented, "AR with a centre"))
                     : centre_by_opening(circle, block.words[Address::OpeningAngle].value);
  }
  const Vector centre = centre_by_words(channel, block, circle);
  const double start = (circle.start - centre).norm();
  const double end = (circle.end - centre).norm();
  if (start == 0.0 || std::abs(start - end) > kEndTolerance) {
    return failure(
        AlarmId::CircleEnd,
        fmt::format("the radius is {:.4f} at the start and {:.4f} at the end", start, end));
  }
  return centre;
}

/// A mirrored frame turns the other way; a turned plane is not supported by the machine's arcs.
Result<Turn, Failure> turn_in_machine(const Channel& channel, const Circle& circle) {
  AxisPositions q[3] = {AxisPositions::Zero(), AxisPositions::Zero(), AxisPositions::Zero()};
  q[1][circle.plane.first] = 1.0;
  q[2][circle.plane.second] = 1.0;
  const Frame frame = channel.active_frame();
  const AxisPositions first = frame.apply(q[1]) - frame.apply(q[0]);
  const AxisPositions second = frame.apply(q[2]) - frame.apply(q[0]);
  const double out = std::abs(first[circle.plane.normal]) + std::abs(second[circle.plane.normal]);
  const double stretch = std::abs(first.head<3>().norm() - second.head<3>().norm());
  if (out > 1e-12 || stretch > 1e-12) {
    return failure(AlarmId::NotImplemented, "a circle in a tilted or unequally scaled plane");
  }
  const double cross = first[circle.plane.first] * second[circle.plane.second] -
                       first[circle.plane.second] * second[circle.plane.first];
  const bool clockwise = (circle.turn == Turn::Clockwise) == (cross > 0.0);
  return clockwise ? Turn::Clockwise : Turn::Counterclockwise;
}

Vector in_plane(const AxisPositions& q, const Plane& plane) {
  return {q[plane.first], q[plane.second]};
}

}  // namespace

MaybeFailure move_along_circle(Channel& channel, const Block& block) {
  const auto q_W_end = programmed_end(channel, block);
  if (!q_W_end) {
    return q_W_end.error();
  }
  const AxisPositions q_W_start = channel.present();
  Circle circle;
  circle.plane = channel.plane();
  circle.turn = channel.group[1] == 3 ? Turn::Clockwise : Turn::Counterclockwise;
  circle.start = in_plane(q_W_start, circle.plane);
  circle.end = in_plane(q_W_end.value(), circle.plane);
  const auto centre = centre_of(channel, block, circle);
  if (!centre) {
    return centre.error();
  }
  const auto turn = turn_in_machine(channel, circle);
  const auto feed = feed_in_force(channel);
  if (!turn || !feed) {
    return !turn ? turn.error() : feed.error();
  }
  AxisPositions q_W_centre = q_W_start;
  q_W_centre[circle.plane.first] = centre.value().x();
  q_W_centre[circle.plane.second] = centre.value().y();
  const AxisPositions q_M_centre = channel.to_machine(q_W_centre);
  machine::ArcMove move;
  move.q_M_end = channel.to_machine(q_W_end.value());
  move.first_axis = circle.plane.first;
  move.second_axis = circle.plane.second;
  move.centre_first = q_M_centre[circle.plane.first];
  move.centre_second = q_M_centre[circle.plane.second];
  move.turn = turn.value();
  move.feed_mm_min = feed.value();
  move.ends = block_end(channel);
  return carry_out(channel, move, q_W_end.value(), move.turn == Turn::Clockwise ? 2 : 3);
}

}  // namespace g31::sinumerik

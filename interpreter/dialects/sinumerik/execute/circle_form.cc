#include "interpreter/dialects/sinumerik/execute/circle_form.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace g31::sinumerik {
namespace {

using Vector = PlaneVector;
using machine::Turn;

constexpr double kEndTolerance = 0.01;  // mm, as $MC_CIRCLE_ERROR_CONST
constexpr double kNothing = 1e-9;

// Numbers of group 1.
constexpr int kClockwise = number_in_group("G2");
constexpr int kThroughPoint = number_in_group("CIP");
constexpr int kTangential = number_in_group("CT");

constexpr Address kCentre[] = {Address::CentreX, Address::CentreY, Address::CentreZ};
constexpr Address kMiddle[] = {Address::MiddleX, Address::MiddleY, Address::MiddleZ};

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

/// I, J, K from the start, radii whatever DIAMON says; with AC in work coordinates, as it says.
Vector centre_by_words(const Channel& channel, const Block& block, const Circle& circle) {
  Vector centre = circle.start;
  const int axes[] = {circle.plane.first, circle.plane.second};
  for (int i = 0; i < 2; ++i) {
    const BlockWords::Word& word = block.words[kCentre[axes[i]]];
    if (word.present && is_absolute(word.modification)) {
      centre[i] =
          channel.stored_place(axes[i], word.value, Channel::Counts::Absolute, word.modification);
    } else if (word.present && says_across(word.modification)) {
      centre[i] += channel.stored_place(axes[i], word.value, Channel::Counts::Incremental,
                                        word.modification);
    } else if (word.present) {
      centre[i] += channel.stored(axes[i], word.value);
    }
  }
  return centre;
}

/// AR and the end: the centre lies left or right of the chord.
Result<Vector, Failure> centre_by_opening(const Circle& circle, double degrees) {
  const Vector chord = circle.end - circle.start;
  if (!is_opening_angle(degrees) || chord.norm() == 0.0) {
    return failure(wrong_opening_angle(degrees));
  }
  const double half = degrees / 2.0 * std::numbers::pi / 180.0;
  const double side = circle.turn == Turn::Clockwise ? -1.0 : 1.0;
  return Vector(circle.start + chord / 2.0 +
                side * left_of(chord) / 2.0 * (std::cos(half) / std::sin(half)));
}

/// AR and the centre: the end is where the angle ends.
MaybeFailure end_by_opening(const Block& block, Circle& circle, AxisPositions& q_W_end) {
  const double degrees = block.words[Address::OpeningAngle].value;
  if (block.words.axis(circle.plane.first).present ||
      block.words.axis(circle.plane.second).present) {
    return failure(AlarmId::CircleOverdetermined, "AR, a centre and an end");
  }
  const Vector out = circle.start - circle.centre;
  if (!is_opening_angle(degrees) || out.norm() == 0.0) {
    return failure(wrong_opening_angle(degrees));
  }
  const double turned = degrees * std::numbers::pi / 180.0;
  const double side = circle.turn == Turn::Clockwise ? -1.0 : 1.0;
  circle.end = circle.centre + std::cos(turned) * out + side * std::sin(turned) * left_of(out);
  q_W_end[circle.plane.first] = circle.end.x();
  q_W_end[circle.plane.second] = circle.end.y();
  return std::nullopt;
}

/// CIP: the circle through three points, and the way round that meets the middle one.
MaybeFailure through_middle(const Vector& middle, Circle& circle) {
  const Vector a = middle - circle.start;
  const Vector b = circle.end - circle.start;
  const double area = cross(a, b);
  if (std::abs(area) <= kNothing * a.norm() * b.norm()) {
    return failure(AlarmId::BadIntermediatePoint);
  }
  circle.turn = area < 0.0 ? Turn::Clockwise : Turn::Counterclockwise;
  const Vector offset((b.y() * a.squaredNorm() - a.y() * b.squaredNorm()) / (2.0 * area),
                      (a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) / (2.0 * area));
  circle.centre = circle.start + offset;
  return std::nullopt;
}

/// CT: goes on in the direction in which the move before it ended.
MaybeFailure tangential(const Channel& channel, Circle& circle) {
  AxisPositions q_P_ahead = channel.path_position();
  const AxisPositions q_W = channel.path_to_work(q_P_ahead);
  q_P_ahead.head<3>() += channel.along_P_end.normalized();
  Vector along = in_plane(channel.path_to_work(q_P_ahead) - q_W, circle.plane);
  const Vector chord = circle.end - circle.start;
  if (along.norm() < kNothing || chord.norm() < kNothing) {
    return failure(AlarmId::CircleEnd,
                   "CT needs a move in the plane before it, and another end point");
  }
  along.normalize();
  const double area = cross(along, chord);
  circle.is_straight = std::abs(area) < kNothing * chord.norm();
  if (circle.is_straight) {
    return along.dot(chord) > 0.0 ? std::nullopt
                                  : MaybeFailure(failure(AlarmId::CircleEnd, "CT straight back"));
  }
  circle.centre = circle.start + chord.squaredNorm() / (2.0 * area) * left_of(along);
  circle.turn = area < 0.0 ? Turn::Clockwise : Turn::Counterclockwise;
  return std::nullopt;
}

MaybeFailure by_centre(const Circle& circle) {
  const double start = (circle.start - circle.centre).norm();
  const double end = (circle.end - circle.centre).norm();
  if (start == 0.0 || std::abs(start - end) > kEndTolerance) {
    return failure(
        AlarmId::CircleEnd,
        fmt::format("the radius is {:.4f} at the start and {:.4f} at the end", start, end));
  }
  return std::nullopt;
}

MaybeFailure take(Circle& circle, const Result<Vector, Failure>& centre) {
  if (!centre) {
    return centre.error();
  }
  circle.centre = centre.value();
  return std::nullopt;
}

/// G2 and G3
MaybeFailure find_centre(Channel& channel, const Block& block, Circle& circle,
                         AxisPositions& q_W_end) {
  const bool with_words = has_centre(block, circle.plane);
  if (block.words.has(Address::Radius)) {
    return take(circle, centre_by_radius(
                            circle, block.words[Address::Radius].value * channel.mm_per_length()));
  }
  if (block.words.has(Address::OpeningAngle) && !with_words) {
    return take(circle, centre_by_opening(circle, block.words[Address::OpeningAngle].value));
  }
  circle.centre = is_polar(block) && !with_words ? in_plane(channel.pole.q_W, circle.plane)
                                                 : centre_by_words(channel, block, circle);
  return block.words.has(Address::OpeningAngle) ? end_by_opening(block, circle, q_W_end)
                                                : by_centre(circle);
}

}  // namespace

bool has_centre(const Block& block, const Plane& plane) {
  return block.words.has(kCentre[plane.first]) || block.words.has(kCentre[plane.second]);
}

AxisPositions middle_of(const Channel& channel, const Block& block,
                        const AxisPositions& q_W_start) {
  AxisPositions middle = q_W_start;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const BlockWords::Word& word = block.words[kMiddle[axis]];
    const bool adds = counts_from_present(channel, word.modification);
    const double value = channel.stored_place(
        axis, word.value, adds ? Channel::Counts::Incremental : Channel::Counts::Absolute,
        word.modification);
    if (word.present) {
      middle[axis] = adds ? middle[axis] + value : value;
    }
  }
  return middle;
}

bool is_spatial(const Channel& channel, const Block& block, const AxisPositions& q_W_start,
                const AxisPositions& q_W_end) {
  const int normal = channel.plane().normal;
  const double middle = middle_of(channel, block, q_W_start)[normal];
  return channel.group[Group::Motion] == kThroughPoint && block.words.has(kMiddle[normal]) &&
         (middle != q_W_start[normal] || q_W_end[normal] != q_W_start[normal]);
}

Result<Circle, Failure> programmed_circle(Channel& channel, const Block& block,
                                          AxisPositions& q_W_end) {
  const AxisPositions q_W_start = channel.present();
  Circle circle;
  circle.plane = channel.plane();
  circle.turn =
      channel.group[Group::Motion] == kClockwise ? Turn::Clockwise : Turn::Counterclockwise;
  circle.start = in_plane(q_W_start, circle.plane);
  circle.end = in_plane(q_W_end, circle.plane);
  MaybeFailure wrong;
  if (channel.group[Group::Motion] == kThroughPoint) {
    wrong = through_middle(in_plane(middle_of(channel, block, q_W_start), circle.plane), circle);
  } else if (channel.group[Group::Motion] == kTangential) {
    wrong = tangential(channel, circle);
  } else {
    wrong = find_centre(channel, block, circle, q_W_end);
  }
  return wrong ? Result<Circle, Failure>(*wrong) : circle;
}

double sweep_of(const Circle& circle) {
  const Vector a = circle.start - circle.centre;
  const Vector b = circle.end - circle.centre;
  const double left = std::atan2(cross(a, b), a.dot(b));
  const double sweep = circle.turn == Turn::Counterclockwise ? left : -left;
  const bool is_full = (circle.end - circle.start).norm() < path::kOnePointMm;
  return is_full ? kFullRad : sweep > 0.0 ? sweep : sweep + kFullRad;
}

}  // namespace g31::sinumerik

#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< rad
/// So far along the circle an end of a piece may be standstill or a way along the radius, rad.
inline constexpr double kStandstill = 0.001;

/// A piece of a record along a circle in one direction.
struct CircleTurn {
  std::size_t begin = 0;  ///< first sample
  std::size_t end = 0;    ///< behind the last
  int direction = 1;      ///< +1 counter-clockwise, -1 clockwise
  double from = 0.0;      ///< angle about the centre of the first sample, rad
  double angle = 0.0;     ///< way from the first sample to the last, rad, > 0
  double omega = 0.0;     ///< mean angular speed but for the first and last tenth, rad/s, signed
};

/// A difference of two angles by the shorter way: within half a turn, rad.
inline double shorter_way(double step) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return std::abs(step) <= std::numbers::pi ? step : step - kTurn * std::round(step / kTurn);
}

/// -1 or 1.
inline double sign_of(double value) {
  return value < 0.0 ? -1.0 : 1.0;
}

/// Of a point about a centre, from -pi to pi.
inline double angle_about(const Eigen::Vector2d& centre, const Eigen::Vector2d& p) {
  const Eigen::Vector2d q = p - centre;
  return std::atan2(q.y(), q.x());
}

/// The pieces of a record that run along a circle for 10 degrees or more, in the order of the
/// record.  A sample further than `near` of the radius from the circle belongs to none; nor does
/// standstill at the ends of a piece.  A standstill amid the way ends a piece (`standstills`).
std::vector<CircleTurn> circle_turns(const PlaneSamples& samples, const Circle& circle,
                                     double near);

/// A part of a piece, [begin, end) of its samples, at the same speed.
CircleTurn part_of(const PlaneSamples& samples, const Circle& circle, const CircleTurn& turn,
                   std::size_t begin, std::size_t end);

/// Sum of the ways of the pieces in a direction, rad.
double angle_of(std::span<const CircleTurn> turns, int direction);

/// Whether the pieces of a direction together pass all angles, but for 2 degrees.
bool pass_whole_turn(std::span<const CircleTurn> turns, int direction);

}  // namespace g31::metrology

#pragma once

#include <numbers>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {

inline constexpr double kFullRad = 2.0 * std::numbers::pi;

/// A point or a direction in the plane: mm along its first and second axis, work coordinates.
using PlaneVector = Eigen::Vector2d;

/// Positive where b points to the left of a.
inline double cross(const PlaneVector& a, const PlaneVector& b) {
  return a.x() * b.y() - a.y() * b.x();
}

inline PlaneVector in_plane(const AxisPositions& q, const Plane& plane) {
  return {q[plane.first], q[plane.second]};
}

/// A circle as a block programs it, in its plane and in work coordinates.  A start and an end that
/// coincide make a full circle.
struct Circle {
  Plane plane;
  machine::Turn turn = machine::Turn::Clockwise;
  PlaneVector start = PlaneVector::Zero();
  PlaneVector end = PlaneVector::Zero();
  PlaneVector centre = PlaneVector::Zero();
  bool is_straight = false;  ///< CT to a point straight ahead
};

/// The circle of G2, G3, CIP or CT.
/// @param q_W_end  as the axis words say; AR with a centre makes its own end and sets it
Result<Circle, Failure> programmed_circle(Channel& channel, const Block& block,
                                          AxisPositions& q_W_end);

/// The angle it turns through, rad, in (0, 2 pi].
double sweep_of(const Circle& circle);

/// Whether CIP goes through space: its three points do not lie at one height over the plane.
bool is_spatial(const Channel& channel, const Block& block, const AxisPositions& q_W_start,
                const AxisPositions& q_W_end);

/// The intermediate point of CIP, work coordinates.
AxisPositions middle_of(const Channel& channel, const Block& block, const AxisPositions& q_W_start);

/// Whether I, J or K of the plane stands in the block.
bool has_centre(const Block& block, const Plane& plane);

}  // namespace g31::sinumerik

#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "machine/units/point.h"

namespace g31::machine {

/// The ways to say how a tilted plane lies.  A matrix has the directions of the plane's X, Y and Z
/// in its columns, in the system that the plane is tilted in.

/// A right-handed turn about one of the axes.  Quarter turns are exact.
struct AxisTurn {
  int axis = 0;  ///< 0 X, 1 Y, 2 Z
  double deg = 0.0;
};

[[nodiscard]] Eigen::Matrix3d turn_about(const AxisTurn& turn);

/// A right-handed turn about any direction.
/// @param axis  of length 1
[[nodiscard]] Eigen::Matrix3d turn_about(const Point& axis, double deg);

/// Each turn is about the axis that those before it have turned: R1 R2 R3.  X Y Z and Z Y X are
/// axis by axis (CYCLE800), Z X Z the Euler angles of G68.2, Z Y solid angles.
[[nodiscard]] Eigen::Matrix3d about_turned_axes(const std::array<AxisTurn, 3>& turns);

/// Each turn is about the axis as it was at the beginning: R3 R2 R1 (G68.2 P1).
[[nodiscard]] Eigen::Matrix3d about_fixed_axes(const std::array<AxisTurn, 3>& turns);

/// Projection angles: the plane holds the lines that two of its axes draw in the old coordinate
/// planes; the third angle turns in the plane.  Of X and Y the plane's X stays in the old ZX plane,
/// of Z and X its Z in the old YZ plane, of Y and Z its Y in the old XY plane.
/// @param angles   deg, with X, Y and Z
/// @param in_plane the axis whose angle turns in the plane, 0 X, 1 Y, 2 Z: about that of the plane
/// nullopt: the lines are parallel.
[[nodiscard]] std::optional<Eigen::Matrix3d> by_projection_angles(const Point& angles_deg,
                                                                  int in_plane);

/// X points from `origin` to `on_x`; `beside` lies on the side of Y.  nullopt: on one line.
[[nodiscard]] std::optional<Eigen::Matrix3d> by_three_points(const Point& origin, const Point& on_x,
                                                             const Point& beside);

/// Z as it is, X made perpendicular to it.  nullopt: they are parallel, or one has no length.
[[nodiscard]] std::optional<Eigen::Matrix3d> by_x_and_z(const Point& x, const Point& z);

/// Z as it is, X perpendicular to it and to `upright` (`upright` x Z).  nullopt: they are parallel.
[[nodiscard]] std::optional<Eigen::Matrix3d> by_z_and_upright(const Point& z, const Point& upright);

/// The angle that turns `from` into `to` about an axis, of the parts perpendicular to it: deg, in
/// (-180, 180]; 0 where one of them has no such part.
/// @param axis  of length 1
[[nodiscard]] double angle_about(const Point& axis, const Point& from, const Point& to);

/// An angle less whole turns: deg, in (-180, 180].
[[nodiscard]] double within_half_turn(double deg);

}  // namespace g31::machine

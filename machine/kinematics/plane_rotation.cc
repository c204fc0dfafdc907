#include "machine/kinematics/plane_rotation.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/Geometry>

namespace g31::machine {
namespace {

/// Sine of the angle between directions that count as parallel.
constexpr double kParallel = 1e-9;

/// The part of a direction perpendicular to an axis is rounding alone below this.
constexpr double kNoPart = 1e-14;

struct SineCosine {
  double sine;
  double cosine;
};

SineCosine sine_and_cosine(double deg) {
  const double quarters = std::nearbyint(deg / 90.0);
  const double rest = (deg - 90.0 * quarters) * std::numbers::pi / 180.0;
  const double s = std::sin(rest);
  const double c = std::cos(rest);
  const auto quarter = static_cast<std::size_t>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0));
  const std::array<SineCosine, 4> turned = {{{s, c}, {c, -s}, {-s, -c}, {-c, s}}};
  return turned.at(quarter);
}

/// The direction perpendicular to both, of length 1.
std::optional<Point> crossed(const Point& a, const Point& b) {
  const Point cross = a.cross(b);
  const double length = cross.norm();
  if (!(length > kParallel * a.norm() * b.norm())) {
    return std::nullopt;
  }
  return Point(cross / length);
}

}  // namespace

Eigen::Matrix3d turn_about(const AxisTurn& turn) {
  return turn_about(Point(Point::Unit(turn.axis)), turn.deg);
}

Eigen::Matrix3d turn_about(const Point& axis, double deg) {
  const auto [sine, cosine] = sine_and_cosine(deg);
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return cosine * Eigen::Matrix3d::Identity() + (1.0 - cosine) * axis * axis.transpose() +
         sine * cross;
}

Eigen::Matrix3d about_turned_axes(const std::array<AxisTurn, 3>& turns) {
  return turn_about(turns[0]) * turn_about(turns[1]) * turn_about(turns[2]);
}

Eigen::Matrix3d about_fixed_axes(const std::array<AxisTurn, 3>& turns) {
  return turn_about(turns[2]) * turn_about(turns[1]) * turn_about(turns[0]);
}

std::optional<Eigen::Matrix3d> by_projection_angles(const Point& angles_deg, int in_plane) {
  // Of the two axes in the plane the first is turned about the second and so stays in its old
  // coordinate plane: Y and Z for X, Z and X for Y, X and Y for Z.
  const int first = (in_plane + 1) % 3;
  const int second = (in_plane + 2) % 3;
  const Point stays = turn_about(AxisTurn{second, angles_deg[second]}).col(first);
  const Point line = turn_about(AxisTurn{first, angles_deg[first]}).col(second);
  const std::optional<Point> normal = crossed(stays, line);
  if (!normal) {
    return std::nullopt;
  }
  Eigen::Matrix3d plane;
  plane.col(in_plane) = *normal;
  plane.col(first) = stays;
  plane.col(second) = normal->cross(stays);
  return Eigen::Matrix3d(plane * turn_about(AxisTurn{in_plane, angles_deg[in_plane]}));
}

std::optional<Eigen::Matrix3d> by_three_points(const Point& origin, const Point& on_x,
                                               const Point& beside) {
  const std::optional<Point> z = crossed(on_x - origin, beside - origin);
  return z ? by_x_and_z(on_x - origin, *z) : std::nullopt;
}

std::optional<Eigen::Matrix3d> by_x_and_z(const Point& x, const Point& z) {
  const std::optional<Point> y = crossed(z, x);
  if (!y) {
    return std::nullopt;
  }
  Eigen::Matrix3d plane;
  plane.col(2) = z.normalized();
  plane.col(1) = *y;
  plane.col(0) = y->cross(plane.col(2));
  return plane;
}

std::optional<Eigen::Matrix3d> by_z_and_upright(const Point& z, const Point& upright) {
  const std::optional<Point> x = crossed(upright, z);
  return x ? by_x_and_z(*x, z) : std::nullopt;
}

double angle_about(const Point& axis, const Point& from, const Point& to) {
  const Point a = from - axis * axis.dot(from);
  const Point b = to - axis * axis.dot(to);
  if (a.norm() < kNoPart * from.norm() || b.norm() < kNoPart * to.norm()) {
    return 0.0;
  }
  return within_half_turn(std::atan2(axis.dot(a.cross(b)), a.dot(b)) * 180.0 / std::numbers::pi);
}

double within_half_turn(double deg) {
  const double rest = std::remainder(deg, 360.0);
  return rest <= -180.0 ? rest + 360.0 : rest;
}

}  // namespace g31::machine

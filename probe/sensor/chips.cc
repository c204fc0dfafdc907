#include "probe/sensor/chips.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "parts/geometry/placement.h"

namespace g31::probe {
namespace {

using Polygon = std::vector<Point>;

/// What of a convex polygon has its coordinate at most `limit`; with sense -1 at least -`limit`.
Polygon cut(const Polygon& polygon, int axis, double sense, double limit) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& p_next = polygon[(i + 1) % polygon.size()];
    const double beyond = sense * p[axis] - limit;
    const double next = sense * p_next[axis] - limit;
    if (beyond <= 0.0) {
      kept.push_back(p);
    }
    if ((beyond < 0.0 && next > 0.0) || (beyond > 0.0 && next < 0.0)) {
      kept.push_back(p + beyond / (beyond - next) * (p_next - p));
    }
  }
  return kept;
}

/// From the axis of a disc to the convex polygon, seen along that axis; 0 where it is around it.
double from_axis(const Polygon& polygon) {
  double nearest = polygon.front().head<2>().norm();
  bool left = false;
  bool right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d from = polygon[i].head<2>();
    const Eigen::Vector2d along = polygon[(i + 1) % polygon.size()].head<2>() - from;
    const double squared = along.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(-from.dot(along) / squared, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (from + share * along).norm());
    const double turn = along.x() * -from.y() + along.y() * from.x();
    left = left || turn > 0.0;
    right = right || turn < 0.0;
  }
  const bool is_around = left != right;
  return is_around ? 0.0 : nearest;
}

/// @param triangle  in the frame of the middle of the plate
bool is_on(Polygon triangle, const Point& half, bool is_disc) {
  triangle = cut(triangle, 2, 1.0, half.z() + kOnPlateMm);
  triangle = cut(triangle, 2, -1.0, half.z() - kOnPlateMm);
  if (is_disc) {
    return !triangle.empty() && from_axis(triangle) <= half.x() + kOnPlateMm;
  }
  for (const int axis : {0, 1}) {
    for (const double sense : {1.0, -1.0}) {
      triangle = cut(triangle, axis, sense, half[axis] + kOnPlateMm);
    }
  }
  return !triangle.empty();
}

}  // namespace

bool is_chip(const ProbedPart& part, const ToolProbeSetup& setup) {
  if (part.role != Role::Part || setup.shape == ToolProbeShape::Laser) {
    return false;
  }
  const Point half = 0.5 * extent_mm(setup);
  const Eigen::Matrix3d R_TM =
      parts::rotation_to_machine({Point::Zero(), setup.rotate_deg}).transpose();
  const auto in_plate = [&](std::uint32_t vertex) {
    const Point& p_M = part.mesh_M.vertices[vertex];
    return Point(R_TM * (p_M - setup.p_M_at) + Point(0.0, 0.0, half.z()));
  };
  return std::ranges::any_of(part.mesh_M.triangles, [&](const auto& triangle) {
    const Point a = in_plate(triangle[0]);
    const Point b = in_plate(triangle[1]);
    const Point c = in_plate(triangle[2]);
    const auto is_apart = [&](const Point& lowest, const Point& highest) {
      return (lowest.array() > half.array() + kOnPlateMm).any() ||
             (highest.array() < -half.array() - kOnPlateMm).any();
    };
    return !is_apart(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)) &&
           is_on({a, b, c}, half, setup.shape == ToolProbeShape::Disc);
  });
}

}  // namespace g31::probe

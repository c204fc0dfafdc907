#include "probe/contact/sweep_triangle.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace g31::probe {
namespace {

using parts::Path;

/// The contact with a sphere around `centre`.
double sweep_sphere(const Path& path, const Point& centre, double radius) {
  const Point to_centre = centre - path.from;
  const double closest = to_centre.dot(path.direction);
  if (closest < 0.0) {
    return kNoContact;
  }
  const double offset = (to_centre - closest * path.direction).norm();
  if (offset > radius + kTangencyMm) {
    return kNoContact;
  }
  // (r - q)(r + q) rather than b^2 - a c: nothing cancels when the ball almost passes by.
  const double half_chord = std::sqrt(std::max(0.0, (radius - offset) * (radius + offset)));
  // A negative result with the closest approach still ahead is a start in touch, and roundoff.
  return std::max(0.0, closest - half_chord);
}

/// u x e, accurately where the two are nearly parallel and cheaply elsewhere.
Point cross_for_sweep(const Point& u, const Point& e) {
  constexpr double kSteepSquared = 0.01;
  const Point cross = u.cross(e);
  return cross.squaredNorm() > kSteepSquared ? cross : accurate_cross(u, e);
}

/// The contact with the capsule around edge i.  Its round end caps take part only where the path
/// enters the endless cylinder beyond the end: a capsule is convex.
double sweep_capsule(const Path& path, const ContactTriangle& triangle, std::size_t i,
                     double radius) {
  constexpr double kParallelSquared = 1e-30;
  const ContactEdge side = triangle.edge(i);
  if (side.length == 0.0) {
    return sweep_sphere(path, side.start, radius);
  }
  const Point& edge = side.direction;
  const Point to_start = side.start - path.from;
  const Point across = cross_for_sweep(path.direction, edge);
  const double sine_squared = across.squaredNorm();
  double entry = 0.0;
  double closest = -1.0;
  if (sine_squared > kParallelSquared) {
    const double offset_times_sine = to_start.dot(across);
    const double reach = radius + kTangencyMm;
    if (offset_times_sine * offset_times_sine > reach * reach * sine_squared) {
      return kNoContact;
    }
    const double sine = std::sqrt(sine_squared);
    const double offset = std::fabs(offset_times_sine) / sine;
    const double half_chord =
        std::sqrt(std::max(0.0, (radius - offset) * (radius + offset))) / sine;
    closest = to_start.dot(edge.cross(across)) / sine_squared;
    entry = closest - half_chord;
    if (closest + half_chord < 0.0) {
      return kNoContact;
    }
  }
  const double along = std::max(0.0, entry) * path.direction.dot(edge) - to_start.dot(edge);
  if (along < 0.0) {
    return sweep_sphere(path, side.start, radius);
  }
  if (along > side.length) {
    return sweep_sphere(path, triangle.vertices[(i + 1) % 3], radius);
  }
  // Beside the edge and already inside its cylinder: in touch, so it matters only where it goes.
  if (entry <= 0.0) {
    return closest >= 0.0 ? 0.0 : kNoContact;
  }
  return entry;
}

struct PlaneEntry {
  bool reachable = true;  ///< false: the path stays beyond the radius on one side
  double s = kNoContact;  ///< where the offset plane on the start's side is crossed
};

PlaneEntry sweep_plane(const Path& path, const ContactTriangle& triangle, double radius) {
  const double height = (path.from - triangle.vertices[0]).dot(triangle.normal);
  const double climb = path.direction.dot(triangle.normal);
  const double side = height < 0.0 ? -1.0 : 1.0;
  const double gap = side * height - radius;
  const double approach = -side * climb;
  if (gap < -kTangencyMm) {
    return {};
  }
  if (gap - approach * path.length > kTangencyMm) {
    return {false, kNoContact};
  }
  if (approach <= 0.0) {
    return {};
  }
  const double rough = std::max(0.0, gap) / approach;
  // Measured again from nearby: a thin triangle's normal is not good enough for a long lever.
  const Point there = path.from + rough * path.direction;
  const double rest = side * (there - triangle.vertices[0]).dot(triangle.normal) - radius;
  return {true, std::max(0.0, rough + rest / approach)};
}

}  // namespace

double sweep_triangle(const Path& path, const ContactTriangle& triangle, Features features,
                      double radius) {
  double first = kNoContact;
  bool found_on_face = false;
  if ((features & kFace) != 0 && !triangle.is_sliver()) {
    const PlaneEntry plane = sweep_plane(path, triangle, radius);
    if (!plane.reachable) {
      return kNoContact;
    }
    found_on_face =
        plane.s < kNoContact && triangle.is_above_or_below(path.from + plane.s * path.direction);
    if (found_on_face) {
      first = plane.s;
    }
  }
  // Before it crosses the offset plane a ball touches no edge either: a face contact is the first.
  for (std::size_t i = 0; i < 3 && !found_on_face; ++i) {
    if ((features & edge_feature(i)) != 0) {
      first = std::min(first, sweep_capsule(path, triangle, i, radius));
    }
  }
  if (first > path.length + kTangencyMm) {
    return kNoContact;
  }
  return std::min(first, path.length);
}

double sweep_triangle(const Path& path, const ContactTriangle& triangle, double radius) {
  return sweep_triangle(path, triangle, kAllFeatures, radius);
}

}  // namespace g31::probe

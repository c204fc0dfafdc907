#include "probe/tooling/nearest_of_simplex.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace g31::probe {
namespace {

using Shares = std::array<double, 4>;

/// Of the triangle a, b, c the shares of its point nearest to 0 (regions of Voronoi).
std::array<double, 3> nearest_of_triangle(const Point& a, const Point& b, const Point& c) {
  const Point ab = b - a;
  const Point ac = c - a;
  const double d1 = -ab.dot(a);
  const double d2 = -ac.dot(a);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {1.0, 0.0, 0.0};
  }
  const double d3 = -ab.dot(b);
  const double d4 = -ac.dot(b);
  if (d3 >= 0.0 && d4 <= d3) {
    return {0.0, 1.0, 0.0};
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double t = d1 / (d1 - d3);
    return {1.0 - t, t, 0.0};
  }
  const double d5 = -ab.dot(c);
  const double d6 = -ac.dot(c);
  if (d6 >= 0.0 && d5 <= d6) {
    return {0.0, 0.0, 1.0};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double t = d2 / (d2 - d6);
    return {1.0 - t, 0.0, t};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0.0, 1.0 - t, t};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

double nearest_of_edge(const Point& a, const Point& b) {
  const Point ab = b - a;
  const double squared = ab.squaredNorm();
  return squared > 0.0 ? std::clamp(-a.dot(ab) / squared, 0.0, 1.0) : 0.0;
}

/// Whether 0 is on the side of the plane a, b, c where d is not; a flat tetrahedron has no inside.
bool is_outside(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point n = (b - a).cross(c - a);
  return (-a).dot(n) * (d - a).dot(n) <= 0.0;
}

/// Shares of the point of the tetrahedron nearest to 0; all > 0 where it is inside.
Shares nearest_of_tetrahedron(const std::array<Point, 4>& p) {
  constexpr std::array<std::array<std::size_t, 4>, 4> kFaces = {
      {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}}};
  Shares best = {0.25, 0.25, 0.25, 0.25};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k, other] : kFaces) {
    if (!is_outside(p[i], p[j], p[k], p[other])) {
      continue;
    }
    const auto [a, b, c] = nearest_of_triangle(p[i], p[j], p[k]);
    const double squared = (a * p[i] + b * p[j] + c * p[k]).squaredNorm();
    if (squared < least) {
      least = squared;
      best = {};
      best[i] = a;
      best[j] = b;
      best[k] = c;
    }
  }
  return best;
}

Shares nearest_shares(const std::array<Point, 4>& p, std::size_t count) {
  if (count == 1) {
    return {1.0, 0.0, 0.0, 0.0};
  }
  if (count == 2) {
    const double t = nearest_of_edge(p[0], p[1]);
    return {1.0 - t, t, 0.0, 0.0};
  }
  if (count == 3) {
    const auto [a, b, c] = nearest_of_triangle(p[0], p[1], p[2]);
    return {a, b, c, 0.0};
  }
  return nearest_of_tetrahedron(p);
}

}  // namespace

Point reduce_to_nearest(Simplex& simplex, const Point& x) {
  std::array<Point, 4> from = {};
  for (std::size_t i = 0; i < simplex.count; ++i) {
    from[i] = simplex.points[i].p - x;
  }
  const Shares shares = nearest_shares(from, simplex.count);
  Point nearest = Point::Zero();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < simplex.count; ++i) {
    if (shares[i] > 0.0) {
      nearest += shares[i] * from[i];
      simplex.points[kept] = simplex.points[i];
      simplex.shares[kept] = shares[i];
      ++kept;
    }
  }
  simplex.count = kept;
  return kept == 4 ? Point::Zero() : Point(-nearest);
}

}  // namespace g31::probe

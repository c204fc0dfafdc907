#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// The solid angle under which a triangle is seen from p, -2 pi..2 pi, positive from behind; 0 from
/// a corner.  A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125.
inline double solid_angle(const Point& p, const Point& v0, const Point& v1, const Point& v2) {
  const Point a = v0 - p;
  const Point b = v1 - p;
  const Point c = v2 - p;
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double over = a.dot(b.cross(c));
  const double under = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return over == 0.0 && under == 0.0 ? 0.0 : 2.0 * std::atan2(over, under);
}

/// How often a mesh goes around p: 1 inside a solid whose normals point outwards, 0 outside, -1 in
/// one that is turned inside out.  Holes and facets that disagree change it a little, never at
/// once: no ray can slip through.  Takes time with the number of triangles.
inline double winding_number(const Mesh& mesh, const Point& p) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += solid_angle(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  }
  return sum / (4.0 * std::numbers::pi);
}

}  // namespace g31::parts

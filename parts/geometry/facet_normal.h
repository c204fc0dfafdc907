#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include <Eigen/Geometry>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// The unit normal of a facet by the order of its corners; nullopt: it is flat, its height at most
/// 1e-9 of its longest side.
inline std::optional<Point> facet_normal(const Mesh& mesh, std::uint32_t t) {
  constexpr double kHeight = 1e-9;
  const auto& v = mesh.triangles[t];
  const Point a = mesh.vertices[v[1]] - mesh.vertices[v[0]];
  const Point b = mesh.vertices[v[2]] - mesh.vertices[v[0]];
  const Point across = a.cross(b);
  const double area = across.norm();
  const double longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
  return area <= kHeight * longest ? std::nullopt : std::optional<Point>(across / area);
}

}  // namespace g31::parts

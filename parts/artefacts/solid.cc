#include "parts/artefacts/solid.h"

#include <cstdint>
#include <numeric>
#include <vector>

#include "parts/geometry/triangulate.h"

namespace g31::parts {

Mesh revolved(std::span<const Point2> profile, std::size_t sides) {
  Mesh mesh;
  std::vector<std::size_t> first;
  for (const Point2& p : profile) {
    first.push_back(mesh.vertices.size());
    if (p.x() == 0.0) {
      mesh.vertices.emplace_back(0.0, 0.0, p.y());
      continue;
    }
    for (const Point2& corner : tangent_polygon(p.x(), sides)) {
      mesh.vertices.emplace_back(corner.x(), corner.y(), p.y());
    }
  }
  const auto on_axis = [&](std::size_t k) { return profile[k].x() == 0.0; };
  const auto vertex = [&](std::size_t k, std::size_t i) {
    return static_cast<std::uint32_t>(first[k] + (on_axis(k) ? 0 : i % sides));
  };
  const bool is_open = on_axis(0) && on_axis(profile.size() - 1);
  for (std::size_t k = is_open ? 1 : 0; k < profile.size(); ++k) {
    const std::size_t from = (k + profile.size() - 1) % profile.size();
    for (std::size_t i = 0; i < sides; ++i) {
      if (!on_axis(from)) {
        mesh.triangles.push_back({vertex(from, i), vertex(k, i), vertex(from, i + 1)});
      }
      if (!on_axis(k)) {
        mesh.triangles.push_back({vertex(from, i + 1), vertex(k, i), vertex(k, i + 1)});
      }
    }
  }
  return mesh;
}

Mesh extruded(std::span<const Point2> outline, double width) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (const double y : {-0.5 * width, 0.5 * width}) {
    for (const Point2& p : outline) {
      mesh.vertices.emplace_back(p.x(), y, p.y());
    }
  }
  std::vector<std::uint32_t> front(count);
  std::iota(front.begin(), front.end(), 0U);
  for (const auto& [a, b, c] : triangulated(mesh.vertices, front)) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a + count, c + count, b + count});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({i, i + count, next});
    mesh.triangles.push_back({next, i + count, next + count});
  }
  return mesh;
}

}  // namespace g31::parts

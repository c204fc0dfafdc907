#include "tools/gltf/gltf_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace g31::gltf {

parts::Mesh small_ball(double radius_mm) {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  parts::Mesh mesh;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      for (const Point& corner : {Point(0, a, b), Point(a, b, 0), Point(b, 0, a)}) {
        mesh.vertices.emplace_back(radius_mm * corner.normalized());
      }
    }
  }
  // Three corners that are all next to each other make a face.
  const double edge = 1.1 * 2.0 * radius_mm / std::sqrt(golden * golden + 1.0);
  const auto close = [&](std::uint32_t a, std::uint32_t b) {
    return (mesh.vertices[a] - mesh.vertices[b]).norm() < edge;
  };
  for (std::uint32_t a = 0; a < 12; ++a) {
    for (std::uint32_t b = a + 1; b < 12; ++b) {
      for (std::uint32_t c = b + 1; c < 12; ++c) {
        if (!close(a, b) || !close(b, c) || !close(c, a)) {
          continue;
        }
        const Point normal =
            (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
        if (normal.dot(mesh.vertices[a]) > 0.0) {
          mesh.triangles.push_back({a, b, c});
        } else {
          mesh.triangles.push_back({a, c, b});
        }
      }
    }
  }
  return mesh;
}

std::vector<Point> segments_of(std::span<const picture::Way> ways, picture::PathKind kind) {
  std::vector<Point> segments;
  for (const picture::Way& way : ways) {
    if (way.kind != kind) {
      continue;
    }
    for (std::size_t i = 1; i < way.points.size(); ++i) {
      if (way.points[i] != way.points[i - 1]) {
        segments.insert(segments.end(), {way.points[i - 1], way.points[i]});
      }
    }
  }
  return segments;
}

parts::Mesh tubes_about(std::span<const Point> segments, double radius_mm) {
  constexpr std::uint32_t kSides = 3;
  parts::Mesh tubes;
  for (std::size_t i = 0; i + 1 < segments.size(); i += 2) {
    const Point along = (segments[i + 1] - segments[i]).normalized();
    const Point aside = along.unitOrthogonal();
    const Point across = along.cross(aside);
    const auto first = static_cast<std::uint32_t>(tubes.vertices.size());
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const double angle = 2.0 * std::numbers::pi * side / kSides;
      const Point off = radius_mm * (std::cos(angle) * aside + std::sin(angle) * across);
      tubes.vertices.emplace_back(segments[i] + off);
      tubes.vertices.emplace_back(segments[i + 1] + off);
    }
    for (std::uint32_t side = 0; side < kSides; ++side) {
      const std::uint32_t a = first + 2 * side;
      const std::uint32_t b = first + 2 * ((side + 1) % kSides);
      tubes.triangles.push_back({a, b, b + 1});
      tubes.triangles.push_back({a, b + 1, a + 1});
    }
  }
  return tubes;
}

std::vector<Point> shades_by_height(const parts::Mesh& mesh_M) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Point& p : mesh_M.vertices) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  constexpr double kDarkest = 0.6;
  std::vector<Point> shades;
  for (const Point& p : mesh_M.vertices) {
    const double share = high > low ? (p.z() - low) / (high - low) : 1.0;
    shades.emplace_back(Point::Constant(kDarkest + (1.0 - kDarkest) * share));
  }
  return shades;
}

}  // namespace g31::gltf

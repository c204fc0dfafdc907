#include "parts/artefacts/ring_gauge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

namespace g31::parts {
namespace {

constexpr double kMostFacets = 100000.0;

/// How many facets keep the corners within the sagitta; a double, as it may be beyond any integer.
double facets_wanted(const RingGauge& ring) {
  const double radius = 0.5 * ring.outer_diameter_mm;
  // Corners stand at radius / cos(pi / facets).  atan of the tangent rather than acos: acos loses
  // half its digits near 1, and the sagitta is tiny against the radius.
  const double tangent = std::sqrt(ring.sagitta_mm * (2.0 * radius + ring.sagitta_mm)) / radius;
  return std::max(4.0, 4.0 * std::ceil(std::numbers::pi / std::atan(tangent) / 4.0));
}

/// The corners of a regular polygon whose sides are tangent to the circle of that radius, counter-
/// clockwise; the middle of the side before corner 0 lies on +X.
///
/// Built from one octant by mirroring and quarter turns, so that the sides on the axes are exactly
/// at the radius and the polygon is exactly symmetric.
std::vector<Point> polygon(double radius, std::size_t corners) {
  const std::size_t quarter = corners / 4;
  const double half_step = std::numbers::pi / static_cast<double>(corners);
  std::vector<Point> points(corners);
  for (std::size_t i = 0; i < quarter; ++i) {
    const std::size_t mirrored = std::min(i, quarter - 1 - i);
    const double angle = static_cast<double>(2 * mirrored + 1) * half_step;
    // The quotient first: it is exactly 1 for the corner next to the axis.
    const double along = radius * (std::cos(angle) / std::cos(half_step));
    const double across = radius * (std::sin(angle) / std::cos(half_step));
    const double x = mirrored == i ? along : across;
    const double y = mirrored == i ? across : along;
    points[i] = {x, y, 0.0};
    points[i + quarter] = {-y, x, 0.0};
    points[i + 2 * quarter] = {-x, -y, 0.0};
    points[i + 3 * quarter] = {y, -x, 0.0};
  }
  return points;
}

std::optional<std::string> why_impossible(const RingGauge& ring) {
  for (const double size :
       {ring.bore_mm, ring.outer_diameter_mm, ring.height_mm, ring.sagitta_mm}) {
    if (!std::isfinite(size) || size <= 0.0) {
      return "bore, outer_diameter, height and sagitta of a ring must be greater than 0 mm";
    }
  }
  if (ring.bore_mm >= ring.outer_diameter_mm) {
    return "the bore of a ring must be smaller than its outer_diameter";
  }
  if (facets_wanted(ring) > kMostFacets) {
    return "the sagitta of the ring is too small: it would take more than 100000 facets";
  }
  return std::nullopt;
}

}  // namespace

Result<Mesh, std::string> ring_gauge_mesh(const RingGauge& ring) {
  if (auto impossible = why_impossible(ring)) {
    return *std::move(impossible);
  }
  const auto facets = static_cast<std::size_t>(facets_wanted(ring));
  const std::vector<Point> inside = polygon(0.5 * ring.bore_mm, facets);
  const std::vector<Point> outside = polygon(0.5 * ring.outer_diameter_mm, facets);
  const Point down(0.0, 0.0, -ring.height_mm);

  Mesh mesh;
  mesh.vertices.reserve(4 * facets);
  mesh.triangles.reserve(8 * facets);
  for (std::size_t i = 0; i < facets; ++i) {
    mesh.vertices.push_back(inside[i]);
    mesh.vertices.push_back(outside[i]);
    mesh.vertices.emplace_back(outside[i] + down);
    mesh.vertices.emplace_back(inside[i] + down);
  }
  // Around the cross-section: top face, outside, bottom face, bore.
  const auto vertex = [&](std::size_t i, std::size_t corner) {
    return static_cast<std::uint32_t>(4 * (i % facets) + corner % 4);
  };
  for (std::size_t i = 0; i < facets; ++i) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      mesh.triangles.push_back({vertex(i, corner), vertex(i, corner + 1), vertex(i + 1, corner)});
      mesh.triangles.push_back(
          {vertex(i + 1, corner), vertex(i, corner + 1), vertex(i + 1, corner + 1)});
    }
  }
  return mesh;
}

}  // namespace g31::parts

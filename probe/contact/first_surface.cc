#include "probe/contact/first_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace g31::probe {
namespace {

/// Of a side: a ray that meets an edge meets at least one of its triangles.
constexpr double kBorder = 1e-9;
/// Sine of the angle between ray and triangle below which it goes along the triangle.
constexpr double kAlong = 1e-12;

/// Moeller and Trumbore (1997): the point as a mix of the corners.
std::optional<double> met_at(const ContactTriangle& triangle, const parts::Path& ray) {
  const auto& [a, b, c] = triangle.vertices;
  const Point side_b = b - a;
  const Point side_c = c - a;
  const Point across = ray.direction.cross(side_c);
  const double volume = side_b.dot(across);
  if (std::fabs(volume) <= kAlong * side_b.norm() * side_c.norm()) {
    return std::nullopt;
  }
  const Point from_a = ray.from - a;
  const Point turned = from_a.cross(side_b);
  const double share_b = from_a.dot(across) / volume;
  const double share_c = ray.direction.dot(turned) / volume;
  if (share_b < -kBorder || share_c < -kBorder || share_b + share_c > 1.0 + kBorder) {
    return std::nullopt;
  }
  return side_c.dot(turned) / volume;
}

/// The places on a ray's line where it goes into the sphere and out of it are `half` before and
/// behind the one nearest to the centre.
std::optional<double> first_of_sphere(const parts::Sphere& sphere, const parts::Path& ray) {
  const Point to_centre = sphere.centre - ray.from;
  const double nearest = to_centre.dot(ray.direction);
  const double offset = (to_centre - nearest * ray.direction).norm();
  if (offset > sphere.radius) {
    return std::nullopt;
  }
  const double half = std::sqrt((sphere.radius - offset) * (sphere.radius + offset));
  const double first = nearest >= half ? nearest - half : nearest + half;
  return first >= 0.0 && first <= ray.length ? std::optional(first) : std::nullopt;
}

}  // namespace

std::optional<double> first_surface(const ContactMesh& mesh, const parts::Path& ray) {
  if (mesh.sphere()) {
    return first_of_sphere(*mesh.sphere(), ray);
  }
  std::optional<double> first;
  mesh.tree().visit_along(ray, kBoxMarginMm, [&](std::uint32_t slot) {
    const double end = first.value_or(ray.length);
    const auto at = met_at(mesh.triangles()[slot], ray);
    if (at && *at >= 0.0 && *at <= end) {
      first = at;
    }
    return first.value_or(ray.length);
  });
  return first;
}

}  // namespace g31::probe

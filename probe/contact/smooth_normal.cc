#include "probe/contact/smooth_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace g31::probe {
namespace {

/// Corners nearer than this are one.
constexpr double kSameCornerMm = 1e-6;

std::optional<std::uint32_t> slot_of(const ContactMesh& mesh, const SweepHit& hit) {
  std::optional<std::uint32_t> found;
  mesh.visit_within(hit.p_M_point, kSameCornerMm, [&](std::uint32_t slot, const Nearest&) {
    found = mesh.index_of(slot) == hit.triangle ? std::optional(slot) : found;
  });
  return found;
}

/// The angle of a triangle at a corner; nullopt: none of its corners is there.
std::optional<double> angle_at(const ContactTriangle& triangle, const Point& corner) {
  for (std::size_t i = 0; i < 3; ++i) {
    if ((triangle.vertices[i] - corner).norm() < kSameCornerMm) {
      const Point a = triangle.vertices[(i + 1) % 3] - triangle.vertices[i];
      const Point b = triangle.vertices[(i + 2) % 3] - triangle.vertices[i];
      return std::atan2(a.cross(b).norm(), a.dot(b));
    }
  }
  return std::nullopt;
}

/// Of the facets that meet at a corner smoothly.  @param outwards  normal of the one touched
Point normal_at(const ContactMesh& mesh, const Point& corner, const Point& outwards) {
  Point sum = Point::Zero();
  mesh.visit_within(corner, kSameCornerMm, [&](std::uint32_t slot, const Nearest&) {
    const ContactTriangle& triangle = mesh.triangles()[slot];
    const auto angle = triangle.is_sliver() ? std::nullopt : angle_at(triangle, corner);
    const double along = triangle.normal.dot(outwards);
    if (angle && std::abs(along) >= kCreaseCosine) {
      sum += *angle * std::copysign(1.0, along) * triangle.normal;
    }
  });
  return sum;
}

/// A facet with the normals at its corners.
struct Facet {
  /// @param up  its normal towards the ball
  Facet(const ContactTriangle& given, const Point& up) : triangle(given), normal(up) {
    const auto& v = triangle.vertices;
    Eigen::Matrix3d edges;
    edges << v[1] - v[0], v[2] - v[0], normal;
    shares = edges.inverse();
  }

  ContactTriangle triangle;
  Point normal;
  std::array<Point, 3> corners = {};
  Eigen::Matrix3d shares;  ///< of a way from the first corner: along two edges, and up

  /// @param p  in its plane, beyond its edges, too
  [[nodiscard]] Point normal_over(const Point& p) const {
    const Eigen::Vector3d share = shares * (p - triangle.vertices[0]);
    return ((1.0 - share.x() - share.y()) * corners[0] + share.x() * corners[1] +
            share.y() * corners[2])
        .normalized();
  }
  /// Where the line from c against `direction` meets the plane.
  [[nodiscard]] Point foot(const Point& c, const Point& direction) const {
    const double height = (c - triangle.vertices[0]).dot(normal);
    return c - direction * (height / direction.dot(normal));
  }
};

/// The normal that leads from the surface to c.  Half steps, because a ball larger than a boss
/// makes whole ones overshoot.
Point normal_through(const Facet& facet, const Point& p_M_point, const Point& c) {
  constexpr int kMostSteps = 200;
  constexpr double kSettledMm = 1e-13;
  Point p = p_M_point;
  for (int i = 0; i < kMostSteps; ++i) {
    const Point step = 0.5 * (facet.foot(c, facet.normal_over(p)) - p);
    p += step;
    if (step.norm() < kSettledMm) {
      break;
    }
  }
  return facet.normal_over(p);
}

}  // namespace

Point smooth_normal(const ContactMesh& mesh, const SweepHit& hit) {
  const auto slot = slot_of(mesh, hit);
  if (!slot || mesh.triangles()[*slot].is_sliver()) {
    return hit.n_M;
  }
  const ContactTriangle& triangle = mesh.triangles()[*slot];
  const double along = triangle.normal.dot(hit.n_M);
  if (std::abs(along) < kCreaseCosine) {
    return hit.n_M;  // a sharp edge, or a corner
  }
  Facet facet(triangle, std::copysign(1.0, along) * triangle.normal);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point normal = normal_at(mesh, triangle.vertices[i], facet.normal);
    facet.corners[i] = normal.isZero(0.0) ? facet.normal : normal.normalized();
  }
  const Point smooth = normal_through(facet, hit.p_M_point, hit.p_M_centre);
  return smooth.dot(facet.normal) >= kCreaseCosine ? smooth : hit.n_M;
}

}  // namespace g31::probe

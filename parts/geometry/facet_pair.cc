#include "parts/geometry/facet_pair.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "parts/geometry/facet_normal.h"

namespace g31::parts {
namespace {

/// How far the corners are above a plane, mm.
using Heights = std::array<double, 3>;

/// Where a facet is on a line, mm along it.
struct Chord {
  double from = 0.0;
  double to = 0.0;
};

Heights heights_above(const FacetInPlane& plane, const std::array<Point, 3>& corners) {
  Heights heights{};
  for (std::size_t i = 0; i < 3; ++i) {
    heights[i] = plane.normal.dot(corners[i] - plane.corners[0]);
  }
  return heights;
}

Side side_of(const Heights& heights, double little) {
  const double low = std::min({heights[0], heights[1], heights[2]});
  const double high = std::max({heights[0], heights[1], heights[2]});
  if (low < -little) {
    return high > little ? Side::Across : Side::Beside;
  }
  return high > little ? Side::Beside : Side::In;
}

/// What of a facet lies in a plane that it goes through, along the line `direction` in the plane.
Chord chord_in(const FacetInPlane& facet, const Heights& heights, const Point& direction) {
  Chord chord{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double low = heights[i];
    const double high = heights[next];
    if ((low > 0.0) == (high > 0.0)) {
      continue;
    }
    const double share = low / (low - high);
    const Point p = facet.corners[i] + share * (facet.corners[next] - facet.corners[i]);
    chord.from = std::min(chord.from, direction.dot(p));
    chord.to = std::max(chord.to, direction.dot(p));
  }
  return chord;
}

/// Whether a line along one side of `a`, in its plane, has all of `b` behind it.
bool is_beside_a_side(const FacetInPlane& a, const FacetInPlane& b, double little) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point side = a.corners[(i + 1) % 3] - a.corners[i];
    const Point inwards = a.normal.cross(side);
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Point& p : b.corners) {
      farthest = std::max(farthest, inwards.dot(p - a.corners[i]));
    }
    if (farthest <= 0.0 || farthest * farthest <= little * little * side.squaredNorm()) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<FacetInPlane> facet_in_plane(const Mesh& mesh, std::uint32_t t) {
  const auto normal = facet_normal(mesh, t);
  if (!normal) {
    return std::nullopt;
  }
  const auto& v = mesh.triangles[t];
  return FacetInPlane{{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}, *normal};
}

Side side_of(const FacetInPlane& plane, const std::array<Point, 3>& corners, double little) {
  return side_of(heights_above(plane, corners), little);
}

/// They cross where their pieces of the line in both planes lie over each other.  T. Moeller,
/// Journal of Graphics Tools 2 (1997) 25.
bool go_through(const FacetInPlane& a, const FacetInPlane& b, double little) {
  const Heights of_b = heights_above(a, b.corners);
  const Heights of_a = heights_above(b, a.corners);
  if (side_of(of_b, little) != Side::Across || side_of(of_a, little) != Side::Across) {
    return false;
  }
  const Point direction = a.normal.cross(b.normal).normalized();
  const Chord in_b = chord_in(a, of_a, direction);
  const Chord in_a = chord_in(b, of_b, direction);
  return std::min(in_a.to, in_b.to) - std::max(in_a.from, in_b.from) > little;
}

bool lie_over(const FacetInPlane& a, const FacetInPlane& b, double little) {
  const double least = 16.0 * little;
  return a.normal.dot(b.normal) > 0.0 && side_of(a, b.corners, little) == Side::In &&
         !is_beside_a_side(a, b, least) && !is_beside_a_side(b, a, least);
}

}  // namespace g31::parts

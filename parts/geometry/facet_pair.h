#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// A facet with its plane.
struct FacetInPlane {
  std::array<Point, 3> corners;
  Point normal;  ///< unit vector
};

/// nullopt: it has no area (facet_normal.h).
std::optional<FacetInPlane> facet_in_plane(const Mesh& mesh, std::uint32_t t);

/// How a facet lies to the plane of another one.
enum class Side {
  Beside,  ///< on one side, and not in it
  In,
  Across,
};
/// @param little  mm, what does not count above or below the plane
Side side_of(const FacetInPlane& plane, const std::array<Point, 3>& corners, double little);

/// Whether a facet that is across the plane of another one goes through that, by more than
/// `little` mm along the line in both planes.
bool go_through(const FacetInPlane& a, const FacetInPlane& b, double little);

/// Whether two facets of one plane face the same way and lie over each other, by more than 16
/// times `little` mm: facets that only abut may do so inexactly.
bool lie_over(const FacetInPlane& a, const FacetInPlane& b, double little);

}  // namespace g31::parts

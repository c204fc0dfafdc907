#pragma once

#include <cstdint>

#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// How often something is wrong with a mesh, and where first.
struct Defect {
  std::uint64_t count = 0;
  Point p_P_first = Point::Zero();  ///< mm, on the first one, by the order of vertices or facets
};

/// What is wrong with a mesh that should be the surface of solids.
///
/// A *shell* is what hangs together across edges of exactly two facets; it is closed where all of
/// its edges are such.
struct MeshDefects {
  /// Edges of one facet only: holes, T-junctions, gaps.
  Defect open_edges;
  /// Facets that turn against most of those around them in the same shell.
  Defect flipped_facets;
  /// Closed shells whose normals point into the material: outermost ones that enclose a negative
  /// volume, ones inside a solid that are no cavity of it, and so on inwards.
  Defect inward_shells;
  /// Shells smaller than a hundredth of the largest, outside of all closed ones, farther from the
  /// larger ones than they are large.
  Defect stray_shells;
  /// Facets without area: a corner in the place of another, or all on a line (to 1e-9 of its
  /// length).
  Defect flat_facets;
  /// Where the surface meets itself: edges of three facets or more, facets with the corners of
  /// another one, facets that go through others (CrossingFacets), shells of which parts are inside
  /// another though no facet is seen to go through one.
  Defect self_contacts;
  std::uint64_t facets_not_searched = 0;  ///< whether they go through others
  std::uint64_t shells_not_placed = 0;    ///< whether they are inside others
};

/// Vertices in the same place must be one (VertexWeld).
///
/// Takes time with the number of facets; where shells may lie in each other, with that of the
/// facets around them, up to kMostShellWork: what is beyond is not judged, and counted.
/// @throws BrokenOff  as `goes_on` has it
MeshDefects defects_of(const Mesh& mesh, const GoesOn& goes_on = {});

/// Facets that are looked at to say which shells lie in which: a second or so.
inline constexpr std::uint64_t kMostShellWork = 20'000'000;

}  // namespace g31::parts

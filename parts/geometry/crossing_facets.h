#pragma once

#include <cstdint>
#include <vector>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Facets that go through each other.
struct CrossingFacets {
  std::vector<std::uint32_t> facets;  ///< those that go through a later one, rising
  std::uint64_t looked_at = 0;        ///< facets, from the first on; not all: the work was spent
};

/// Facets more than this are not looked at: a fifth of a second or so.
inline constexpr std::uint64_t kMostFacetsForCrossings = 100'000;
/// Pairs of facets whose boxes meet; there are about ten for each facet of a careful mesh.
inline constexpr std::uint64_t kMostCrossingPairs = 20'000'000;

/// Looks for facets that have a piece of a line inside both of them, and for those that lie over
/// each other in one plane and face the same way.  Those that touch in a corner, an edge or back to
/// back do not cross; nor do those that reach through each other by less than what a file of
/// float32 numbers cannot say: 2^-22 of the largest coordinate, in a plane 16 times that.  Facets
/// without area and facets with a common edge are left out.
///
/// Of a mesh of more than kMostFacetsForCrossings facets none is looked at.
/// @param most_pairs  of facets whose boxes meet; the search ends with the facet that has more
CrossingFacets crossing_facets(const Mesh& mesh, std::uint64_t most_pairs = kMostCrossingPairs);

}  // namespace g31::parts

#pragma once

#include <cstdint>
#include <vector>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Facets that go through each other.
struct CrossingFacets {
  std::vector<std::uint32_t> facets;  ///< those that go through a later one, rising
  std::uint64_t looked_at = 0;        ///< facets; not all: the work was spent
};

/// Facets more than this are not looked at: a third of a second or so.
inline constexpr std::uint64_t kMostFacetsForCrossings = 500'000;
/// Pairs of boxes that are compared; about 160 for each facet of a careful mesh.
inline constexpr std::uint64_t kMostComparedBoxes = 1'000'000'000;

/// Looks for facets that have a piece of a line inside both of them, and for those that lie over
/// each other in one plane and face the same way.  Those that touch in a corner, an edge or back to
/// back do not cross; nor do those that reach through each other by less than what a file of
/// float32 numbers cannot say: 2^-22 of the largest coordinate, in a plane 16 times that.  Facets
/// without area and facets with a common edge are left out.
///
/// Of a mesh of more than kMostFacetsForCrossings facets none is looked at.
/// @param most_compared  pairs of boxes, the tests of two facets counted as sixteen of them; the
///     search ends behind the group of neighbours that has more
CrossingFacets crossing_facets(const Mesh& mesh, std::uint64_t most_compared = kMostComparedBoxes);

}  // namespace g31::parts

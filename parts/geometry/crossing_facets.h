#pragma once

#include <cstdint>
#include <vector>

#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Facets that go through each other.
struct CrossingFacets {
  std::vector<std::uint32_t> facets;  ///< those that go through a later one, rising
  std::uint64_t looked_at = 0;        ///< facets; not all: the work was spent
};

/// Boxes that are compared for each facet, and at least for all: a careful mesh of any size takes a
/// third of it, a ball of wool is given up after some seconds.
inline constexpr std::uint64_t kMostComparedForEach = 600;
inline constexpr std::uint64_t kMostComparedAtLeast = 1'000'000'000;

/// Looks for facets that have a piece of a line inside both of them, and for those that lie over
/// each other in one plane and face the same way.  Those that touch in a corner, an edge or back to
/// back do not cross; nor do those that reach through each other by less than what a file of
/// float32 numbers cannot say: 2^-22 of the largest coordinate, in a plane 16 times that.  Facets
/// without area and facets with a common edge are left out.
///
/// @param most_compared  boxes, each facet held against another one counted as eight of them; the
///     search ends in the group of neighbours that has more
/// @throws BrokenOff  as `goes_on` has it
CrossingFacets crossing_facets(const Mesh& mesh, std::uint64_t most_compared,
                               const GoesOn& goes_on = {});
/// The same within the usual budget.
CrossingFacets crossing_facets(const Mesh& mesh, const GoesOn& goes_on = {});

}  // namespace g31::parts

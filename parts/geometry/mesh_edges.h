#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// A facet at an edge.
struct EdgeUse {
  std::uint32_t high = 0;  ///< the larger vertex of the edge
  std::uint32_t facet =
      0;  ///< twice its number, and 1 if it goes from the larger vertex to the less

  [[nodiscard]] std::uint32_t number() const { return facet / 2; }
  [[nodiscard]] bool is_downwards() const { return facet % 2 != 0; }
};

/// Calls visit(low, uses) for every edge of a mesh, by its smaller vertex and then the larger;
/// `uses` by rising facets.  Facets with a corner twice have none.  Eight bytes for each side of a
/// facet.
template <typename Visit>
void visit_edges(const Mesh& mesh, Visit&& visit) {
  const auto for_sides = [&](const auto& act) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& corners = mesh.triangles[t];
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
        continue;
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = corners[i];
        const std::uint32_t to = corners[(i + 1) % 3];
        act(std::min(from, to), EdgeUse{std::max(from, to), 2 * t + (from > to ? 1U : 0U)});
      }
    }
  };
  std::vector<std::uint32_t> first(mesh.vertices.size() + 2, 0);
  for_sides([&](std::uint32_t low, const EdgeUse&) { ++first[low + 2]; });
  for (std::size_t v = 2; v < first.size(); ++v) {
    first[v] += first[v - 1];
  }
  std::vector<EdgeUse> uses(first.back());
  for_sides([&](std::uint32_t low, const EdgeUse& use) { uses[first[low + 1]++] = use; });
  for (std::uint32_t low = 0; low < mesh.vertices.size(); ++low) {
    const std::span<EdgeUse> here =
        std::span(uses).subspan(first[low], first[low + 1] - first[low]);
    std::ranges::sort(here, {}, [](const EdgeUse& use) { return std::pair(use.high, use.facet); });
    for (std::size_t i = 0; i < here.size();) {
      std::size_t end = i + 1;
      while (end < here.size() && here[end].high == here[i].high) {
        ++end;
      }
      visit(low, std::span<const EdgeUse>(here.subspan(i, end - i)));
      i = end;
    }
  }
}

}  // namespace g31::parts

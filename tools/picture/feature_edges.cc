#include "tools/picture/feature_edges.h"

#include <cmath>
#include <numbers>
#include <span>

#include "parts/geometry/facet_normal.h"
#include "parts/geometry/mesh_edges.h"

namespace g31::picture {
namespace {

/// Whether the surface bends at an edge of two facets by more than an angle.
bool bends(const parts::Mesh& mesh, std::span<const parts::EdgeUse> uses, double cosine) {
  const auto n_one = parts::facet_normal(mesh, uses[0].number());
  const auto n_other = parts::facet_normal(mesh, uses[1].number());
  if (!n_one || !n_other) {
    return false;
  }
  // Facets that go along the edge the same way are turned over against each other.
  const double sign = uses[0].is_downwards() == uses[1].is_downwards() ? -1.0 : 1.0;
  return sign * n_one->dot(*n_other) < cosine;
}

}  // namespace

std::vector<Segment> feature_edges(const parts::Mesh& mesh, double angle_deg) {
  const double cosine = std::cos(angle_deg * std::numbers::pi / 180.0);
  std::vector<Segment> edges;
  parts::visit_edges(mesh, [&](std::uint32_t low, std::span<const parts::EdgeUse> uses) {
    if (uses.size() != 2 || bends(mesh, uses, cosine)) {
      edges.push_back({mesh.vertices[low], mesh.vertices[uses.front().high]});
    }
  });
  return edges;
}

}  // namespace g31::picture

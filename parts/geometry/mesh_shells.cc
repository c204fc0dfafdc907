#include "parts/geometry/mesh_shells.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <Eigen/Geometry>

#include "machine/base/contract.h"

namespace g31::parts {

FacetUnion::FacetUnion(std::uint32_t facets) : parents_(facets) {
  G31_EXPECTS(facets < 0x8000'0000U);
  for (std::uint32_t i = 0; i < facets; ++i) {
    parents_[i] = 2 * i;
  }
}

FacetUnion::Root FacetUnion::root_of(std::uint32_t facet) {
  std::uint32_t root = facet;
  std::uint32_t turned = 0;
  while (parents_[root] / 2 != root) {
    turned ^= parents_[root] % 2;
    root = parents_[root] / 2;
  }
  // What lies on the way hangs from the root from now on.
  std::uint32_t turned_here = turned;
  for (std::uint32_t at = facet; at != root;) {
    const std::uint32_t parent = std::exchange(parents_[at], 2 * root + turned_here);
    turned_here ^= parent % 2;
    at = parent / 2;
  }
  return {root, turned != 0};
}

bool FacetUnion::join(std::uint32_t a, std::uint32_t b, bool turned) {
  const Root of_a = root_of(a);
  const Root of_b = root_of(b);
  const bool roots_turned = (of_a.turned != of_b.turned) != turned;
  if (of_a.facet == of_b.facet) {
    return !roots_turned;
  }
  const auto [less, more] = std::minmax(of_a.facet, of_b.facet);
  parents_[more] = 2 * less + (roots_turned ? 1U : 0U);
  return true;
}

MeshShells shells_of(const Mesh& mesh, FacetUnion& hanging, const std::vector<bool>& at_bad_edge) {
  MeshShells found;
  const auto facets = static_cast<std::uint32_t>(mesh.triangles.size());
  found.shell_of.resize(facets);
  for (std::uint32_t t = 0; t < facets; ++t) {
    const FacetUnion::Root root = hanging.root_of(t);
    if (root.facet == t) {
      found.shell_of[t] = static_cast<std::uint32_t>(found.shells.size());
      found.shells.push_back({{}, t});
    } else {
      found.shell_of[t] = found.shell_of[root.facet];
    }
    Shell& shell = found.shells[found.shell_of[t]];
    ++shell.facets;
    shell.turned += root.turned ? 1 : 0;
    shell.is_closed = shell.is_closed && !at_bad_edge[t];
    const auto& corners = mesh.triangles[t];
    for (const std::uint32_t corner : corners) {
      shell.box.include(mesh.vertices[corner]);
    }
    const Point& origin = mesh.vertices[mesh.triangles[shell.first_facet][0]];
    const Point a = mesh.vertices[corners[0]] - origin;
    const Point b = mesh.vertices[corners[1]] - origin;
    const double six_volumes = a.cross(b).dot(mesh.vertices[corners[2]] - origin);
    shell.volume += (root.turned ? -six_volumes : six_volumes) / 6.0;
  }
  for (Shell& shell : found.shells) {
    shell.volume = shell.first_is_flipped() ? -shell.volume : shell.volume;
  }
  return found;
}

FacetsByShell::FacetsByShell(const MeshShells& shells)
    : first_(shells.shells.size() + 2, 0), facets_(shells.shell_of.size()) {
  for (const std::uint32_t shell : shells.shell_of) {
    ++first_[shell + 2];
  }
  for (std::size_t i = 2; i < first_.size(); ++i) {
    first_[i] += first_[i - 1];
  }
  for (std::uint32_t t = 0; t < shells.shell_of.size(); ++t) {
    facets_[first_[shells.shell_of[t] + 1]++] = t;
  }
}

}  // namespace g31::parts

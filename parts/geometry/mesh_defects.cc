#include "parts/geometry/mesh_defects.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "parts/geometry/crossing_facets.h"
#include "parts/geometry/facet_normal.h"
#include "parts/geometry/mesh_edges.h"
#include "parts/geometry/mesh_shells.h"
#include "parts/geometry/shell_nesting.h"

namespace g31::parts {
namespace {

void note(Defect& defect, const Point& p) {
  if (defect.count++ == 0) {
    defect.p_P_first = p;
  }
}

class DefectSearch {
 public:
  DefectSearch(const Mesh& mesh, const GoesOn& goes_on)
      : mesh_(mesh), goes_on_(goes_on), steps_(goes_on) {}

  MeshDefects find() {
    const MeshShells found = look_at_edges();
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!facet_normal(mesh_, t)) {
        note(defects_.flat_facets, middle_of(t));
      }
      if (flipped_[t]) {
        note(defects_.flipped_facets, middle_of(t));
      }
    }
    const bool has_crossings = look_for_crossings();
    look_at_shells(found, has_crossings);
    return defects_;
  }

 private:
  MeshShells look_at_edges() {
    const auto facets = static_cast<std::uint32_t>(mesh_.triangles.size());
    FacetUnion hanging(facets);
    std::vector<bool> at_bad_edge(facets, false);
    visit_edges(mesh_, [&](std::uint32_t low, std::span<const EdgeUse> uses) {
      steps_.step();
      if (uses.size() == 2) {
        const bool turned = uses[0].is_downwards() == uses[1].is_downwards();
        static_cast<void>(hanging.join(uses[0].number(), uses[1].number(), turned));
      } else {
        const Point middle = 0.5 * (mesh_.vertices[low] + mesh_.vertices[uses.front().high]);
        note(uses.size() == 1 ? defects_.open_edges : defects_.self_contacts, middle);
        for (const EdgeUse& use : uses) {
          at_bad_edge[use.number()] = true;
        }
      }
      look_for_doubles(low, uses);
    });
    MeshShells found = shells_of(mesh_, hanging, at_bad_edge);
    flipped_.resize(facets);
    for (std::uint32_t t = 0; t < facets; ++t) {
      const Shell& shell = found.shells[found.shell_of[t]];
      flipped_[t] = hanging.root_of(t).turned != shell.first_is_flipped();
    }
    return found;
  }

  /// Facets with the same corners, once each: at the edge of their two least.
  void look_for_doubles(std::uint32_t low, std::span<const EdgeUse> uses) {
    constexpr std::size_t kFew = 16;  // among so many looking is quicker than keeping
    const bool are_many = uses.size() > kFew;
    std::set<std::uint32_t> tops;
    for (std::size_t i = 0; i < uses.size(); ++i) {
      const std::uint32_t top = top_of(low, uses[i]);
      const auto is_top = [&](const EdgeUse& before) { return top_of(low, before) == top; };
      const bool was_before =
          are_many ? !tops.insert(top).second : std::ranges::any_of(uses.first(i), is_top);
      if (are_many) {
        steps_.step();
      }
      if (was_before && top > uses[i].high) {
        note(defects_.self_contacts, middle_of(uses[i].number()));
      }
    }
  }

  /// The corner that is not at the edge; of a flat facet one of those that are.
  [[nodiscard]] std::uint32_t top_of(std::uint32_t low, const EdgeUse& use) const {
    for (const std::uint32_t corner : mesh_.triangles[use.number()]) {
      if (corner != low && corner != use.high) {
        return corner;
      }
    }
    return low;
  }

  bool look_for_crossings() {
    const CrossingFacets crossing = crossing_facets(mesh_, goes_on_);
    for (const std::uint32_t t : crossing.facets) {
      note(defects_.self_contacts, middle_of(t));
    }
    defects_.facets_not_searched = mesh_.triangles.size() - crossing.looked_at;
    return !crossing.facets.empty();
  }

  void look_at_shells(const MeshShells& found, bool has_crossings) {
    const FacetsByShell facets(found);
    const bool is_one = found.shells.size() == 1;
    const std::vector<ShellPlace> places =
        is_one ? std::vector<ShellPlace>{{ShellPlace::Judged::Yes, 0, false}}
               : shell_places(mesh_, found, facets, {kMostShellWork, goes_on_});
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Shell& shell = found.shells[i];
      const Point p = middle_of(shell.first_facet);
      defects_.shells_not_placed += places[i].judged == ShellPlace::Judged::No ? 1U : 0U;
      if (places[i].crosses) {
        if (has_crossings) {
          continue;  // told by its facets
        }
        note(defects_.self_contacts, p);
      } else if (places[i].judged == ShellPlace::Judged::Yes && shell.is_closed &&
                 has_volume(shell) && (shell.volume < 0.0) != (places[i].depth % 2 != 0)) {
        note(defects_.inward_shells, p);
      }
    }
    if (!is_one) {
      for (const std::uint32_t shell : stray_shells(mesh_, found, places)) {
        note(defects_.stray_shells, middle_of(found.shells[shell].first_facet));
      }
    }
  }

  /// Two facets back to back have none.
  static bool has_volume(const Shell& shell) {
    const double size = shell.diagonal();
    return std::fabs(shell.volume) > 1e-12 * size * size * size;
  }

  [[nodiscard]] Point middle_of(std::uint32_t t) const {
    const auto& v = mesh_.triangles[t];
    return (mesh_.vertices[v[0]] + mesh_.vertices[v[1]] + mesh_.vertices[v[2]]) / 3.0;
  }

  const Mesh& mesh_;
  const GoesOn& goes_on_;
  Steps steps_;
  MeshDefects defects_;
  std::vector<bool> flipped_;
};

}  // namespace

MeshDefects defects_of(const Mesh& mesh, const GoesOn& goes_on) {
  return mesh.triangles.empty() ? MeshDefects{} : DefectSearch(mesh, goes_on).find();
}

}  // namespace g31::parts

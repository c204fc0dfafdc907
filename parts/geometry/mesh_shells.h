#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parts/geometry/box.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Which facets hang together, and which of them turn the same way round.
class FacetUnion {
 public:
  explicit FacetUnion(std::uint32_t facets);

  /// Puts two facets together.  @param turned  whether they turn against each other
  /// @returns whether that fits what is known of them
  bool join(std::uint32_t a, std::uint32_t b, bool turned);

  struct Root {
    std::uint32_t facet = 0;  ///< the least of those that hang together
    bool turned = false;      ///< whether the facet asked about turns against it
  };
  [[nodiscard]] Root root_of(std::uint32_t facet);

 private:
  std::vector<std::uint32_t> parents_;  ///< twice the parent, and 1 if it turns the other way round
};

/// Facets that hang together across edges of exactly two facets.
struct Shell {
  Box box;
  std::uint32_t first_facet = 0;
  std::uint32_t facets = 0;
  std::uint32_t turned = 0;  ///< how many of them turn against the first
  bool is_closed = true;
  double volume = 0.0;  ///< mm^3, as most of its facets turn; of a closed one

  /// Whether the first facet is of the fewer.
  [[nodiscard]] bool first_is_flipped() const { return 2 * turned > facets; }
  [[nodiscard]] double diagonal() const { return (box.max - box.min).norm(); }
};

/// The shells of a mesh, and which facet is of which.
struct MeshShells {
  std::vector<Shell> shells;            ///< by their first facets
  std::vector<std::uint32_t> shell_of;  ///< by facets
};

/// @param hanging      facets that share an edge of two
/// @param at_bad_edge  facets with an edge that is none of two
MeshShells shells_of(const Mesh& mesh, FacetUnion& hanging, const std::vector<bool>& at_bad_edge);

/// The facets of each shell, rising.
class FacetsByShell {
 public:
  explicit FacetsByShell(const MeshShells& shells);

  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t shell) const {
    return std::span(facets_).subspan(first_[shell], first_[shell + 1] - first_[shell]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> facets_;
};

}  // namespace g31::parts

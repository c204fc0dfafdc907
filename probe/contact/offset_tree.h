#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "parts/geometry/bvh.h"
#include "probe/contact/contact_mesh.h"
#include "probe/contact/offset_patches.h"

namespace g31::probe {

/// The surface on which the centre of a touching ball lies, as a tree of patches
/// (offset_patches.h).  Of a mesh that is large, or rough and fine beside the ball, patches are
/// made where the ball comes, without those that are hidden.  To those who ask it is immutable.
class OffsetTree {
 public:
  OffsetTree() = default;

  /// @param mesh    outlives the tree
  /// @param radius  mm, > 0
  OffsetTree(const ContactMesh& mesh, double radius);

  /// Calls visit(owner) for every patch within `reach` mm of the path: what of which triangle, by
  /// its slot, a ball may touch there.  `visit` returns how far along the path is still of
  /// interest, mm.
  template <typename Visit>
  void visit_along(const parts::Path& path, double reach, Visit&& visit) const {
    tree_.visit_along(path, reach,
                      [&](std::uint32_t slot) { return visit(PatchOwner::of_slot(slot)); });
  }

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// What patches are made of where a ball comes.
  struct Source {
    OffsetSurface surface;
    std::vector<OffsetRegion> regions;
  };

  std::unique_ptr<Source> source_;  ///< null where all patches are made
  parts::Bvh tree_;
};

}  // namespace g31::probe

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "parts/geometry/bvh.h"
#include "probe/contact/contact_mesh.h"
#include "probe/contact/offset_patches.h"

namespace g31::probe {

/// The surface on which the centre of a touching ball lies, as a tree of patches
/// (offset_patches.h).  Immutable.
class OffsetTree {
 public:
  OffsetTree() = default;

  /// @param radius  mm, > 0
  OffsetTree(const ContactMesh& mesh, double radius);

  /// Calls visit(owner) for every patch within `reach` mm of the path: what of which triangle, by
  /// its slot, a ball may touch there.  `visit` returns how far along the path is still of
  /// interest, mm.
  template <typename Visit>
  void visit_along(const parts::Path& path, double reach, Visit&& visit) const {
    tree_.visit_along(path, reach, [&](std::uint32_t i) {
      return visit(PatchOwner{patches_[i].slot(), patches_[i].features()});
    });
  }

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// What to test where the centre meets a patch: 4 bits of Features, then 28 of the triangle's
  /// slot.
  class Patch {
   public:
    explicit Patch(const PatchOwner& owner) : bits_(owner.features << 28U | owner.triangle) {}
    [[nodiscard]] Features features() const { return bits_ >> 28U; }
    [[nodiscard]] std::uint32_t slot() const { return bits_ & 0x0FFF'FFFFU; }

   private:
    std::uint32_t bits_;
  };

  parts::Bvh tree_;
  std::vector<Patch> patches_;  ///< in the order of the boxes
};

}  // namespace g31::probe

#pragma once

#include <cstdint>
#include <vector>

#include "parts/geometry/bvh.h"
#include "probe/contact/offset_regions.h"
#include "probe/contact/sweep_triangle.h"

namespace g31::probe {

/// What a ball touches that has its centre in a patch.
struct PatchOwner {
  static constexpr std::uint32_t kTriangleBits = 27;

  std::uint32_t triangle = 0;  ///< its slot, less than 2^27
  Features features = 0;       ///< one of these of the triangle

  /// What a tree of patches takes for its slot, and back.
  [[nodiscard]] std::uint32_t as_slot() const { return features << kTriangleBits | triangle; }
  static PatchOwner of_slot(std::uint32_t slot) {
    return {slot & ((1U << kTriangleBits) - 1), slot >> kTriangleBits};
  }
};

/// A box around a piece of the offset surface, mm, to within rounding; the slot is its owner.
using OffsetPatch = parts::Bvh::Twig;

/// Boxes around the whole offset surface: a ball that starts free and meets the mesh does so with
/// its centre in one of them.  From two patches a triangle (smooth meshes) to six.
///
/// Small arcs and caps go in with a face beside them.  Vertices in one place count as one, so
/// unwelded meshes are no worse.  Edges of one triangle alone have half a circle, slivers the whole
/// of their box grown by the radius.  An edge belongs to the first triangle that has it, and so
/// does a vertex.
std::vector<OffsetPatch> offset_patches(const OffsetSurface& surface);

/// The same for a region, without what vertices beside it hide (hiding_vertices.h).
std::vector<OffsetPatch> offset_patches_not_hidden(const OffsetSurface& surface,
                                                   const OffsetRegion& region);

}  // namespace g31::probe

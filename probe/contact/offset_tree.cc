#include "probe/contact/offset_tree.h"

#include <utility>
#include <vector>

#include "machine/base/contract.h"

namespace g31::probe {

OffsetTree::OffsetTree(const ContactMesh& mesh, double radius) {
  G31_EXPECTS(mesh.triangles().size() < (1U << PatchOwner::kTriangleBits));
  OffsetSurface surface(mesh, radius);
  // Of all but the smallest meshes a ball sees little: what it does not come near is never made.
  constexpr std::size_t kLarge = 5'000;
  if (mesh.triangles().size() < kLarge && !is_rough_and_fine(surface)) {
    tree_ = parts::Bvh(offset_patches(surface));
    return;
  }
  std::vector<OffsetRegion> regions = offset_regions(surface);
  std::vector<parts::Box> boxes;
  boxes.reserve(regions.size());
  for (const OffsetRegion& region : regions) {
    boxes.push_back(region.box);
  }
  source_ = std::make_unique<Source>(Source{std::move(surface), std::move(regions)});
  tree_ = parts::Bvh(std::move(boxes), [source = source_.get()](std::uint32_t region) {
    return offset_patches_not_hidden(source->surface, source->regions[region]);
  });
}

std::size_t OffsetTree::memory_bytes() const {
  return tree_.memory_bytes() + (source_ == nullptr
                                     ? 0
                                     : source_->surface.fans.memory_bytes() +
                                           source_->regions.capacity() * sizeof(OffsetRegion));
}

}  // namespace g31::probe

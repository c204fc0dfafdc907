#include "probe/contact/offset_tree.h"

#include <utility>

#include "machine/base/contract.h"

namespace g31::probe {
namespace {

/// What a Patch can number.
constexpr std::size_t kMostTriangles = 1U << 28U;

}  // namespace

OffsetTree::OffsetTree(const ContactMesh& mesh, double radius) {
  G31_EXPECTS(mesh.triangles().size() < kMostTriangles);
  OffsetPatches patches = offset_patches(mesh.mesh(), mesh.triangles(), radius);
  tree_ = parts::Bvh(std::move(patches.boxes), parts::Bvh::Growth::WhereAsked);
  patches_.reserve(patches.owners.size());
  for (const PatchOwner& owner : patches.owners) {
    patches_.emplace_back(owner);
  }
}

std::size_t OffsetTree::memory_bytes() const {
  return tree_.memory_bytes() + patches_.capacity() * sizeof(Patch);
}

}  // namespace g31::probe

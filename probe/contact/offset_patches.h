#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parts/geometry/box.h"
#include "parts/geometry/mesh.h"
#include "probe/contact/contact_triangle.h"
#include "probe/contact/sweep_triangle.h"

namespace g31::probe {

/// What a ball touches that has its centre in a patch.
struct PatchOwner {
  std::uint32_t triangle = 0;
  Features features = 0;  ///< one of these of the triangle
};

/// Pieces of the surface on which the centre of a ball lies that touches the mesh and overlaps it
/// nowhere.  Two lists, because the tree wants the boxes alone and a large mesh has millions.
struct OffsetPatches {
  std::vector<parts::Box> boxes;   ///< mm; each piece lies in its box to within rounding
  std::vector<PatchOwner> owners;  ///< of the pieces, in the same order
};

/// Boxes around the whole offset surface of the mesh, on both sides: a ball that starts free and
/// meets the mesh does so with its centre in one of them.
///
/// Faces moved by the radius to either side, arcs around edges and caps around vertices where they
/// are exposed; small arcs and caps go in with a face beside them.  Vertices in one place count as
/// one, so unwelded meshes are no worse.  Edges of one triangle alone have half a circle, slivers
/// the whole of their box grown by the radius.
///
/// @param triangles  of the mesh, in its order
/// @param radius     mm, > 0
/// From two patches a triangle (smooth meshes) to six.
OffsetPatches offset_patches(const parts::Mesh& mesh, std::span<const ContactTriangle> triangles,
                             double radius);

}  // namespace g31::probe

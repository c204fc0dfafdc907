#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parts/geometry/box.h"
#include "parts/geometry/mesh.h"
#include "probe/contact/contact_triangle.h"
#include "probe/contact/sweep_triangle.h"

namespace g31::probe {

/// A piece of the surface on which the centre of a ball lies that touches the mesh and overlaps it
/// nowhere.
struct OffsetPatch {
  parts::Box box;              ///< mm; the piece lies in it to within rounding
  std::uint32_t triangle = 0;  ///< a ball that touches there touches this triangle
  Features features = 0;       ///< with one of these of its features
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
/// About two patches a triangle for smooth meshes.
std::vector<OffsetPatch> offset_patches(const parts::Mesh& mesh,
                                        std::span<const ContactTriangle> triangles, double radius);

}  // namespace g31::probe

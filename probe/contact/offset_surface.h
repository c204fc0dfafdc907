#pragma once

#include "parts/geometry/corner_fans.h"
#include "probe/contact/contact_mesh.h"

namespace g31::probe {

/// The surface on which the centre of a ball lies that touches the mesh and overlaps it nowhere:
/// faces moved by the radius to either side, arcs around edges and caps around vertices where they
/// are exposed.
struct OffsetSurface {
  const ContactMesh& mesh;  ///< outlives the surface
  parts::CornerFans fans;   ///< of mesh.mesh(): its triangles go by slots
  double radius = 0.0;      ///< mm, > 0

  OffsetSurface(const ContactMesh& on, double ball_radius)
      : mesh(on), fans(on.mesh()), radius(ball_radius) {}
};

}  // namespace g31::probe

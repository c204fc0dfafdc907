#pragma once

#include <string>

#include "machine/base/result.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// A ring gauge, mm.  The part's origin lies on the axis of the bore in the top face; the material
/// reaches from z = 0 down to -height_mm.
struct RingGauge {
  double bore_mm = 39.996;
  double outer_diameter_mm = 79.996;
  double height_mm = 20.0;
  double sagitta_mm = 50e-6;  ///< the most that a facet's corner stands off the true cylinder
};

/// The closed mesh of a ring gauge, normals out of the material.
///
/// Facets are tangent to the true cylinders at their middle, and there are facet middles on the
/// +-X and +-Y axes.  The reason: a measurement of a bore by four touches along the axes then
/// reads the nominal diameter exactly, not the nominal minus some sagitta, and a deviation in a
/// report is the program's, not the mesh's.  In every other direction a radius reads too large by
/// at most sagitta_mm: the default keeps a diameter true to 0.1 um.
///
/// The number of facets, a multiple of 4, follows from the sagitta on the outside, so that it holds
/// on both cylinders.
///
/// Error: a size that is not positive, a bore not smaller than the outside, a sagitta so small that
/// more than a hundred thousand facets would be needed.
Result<Mesh, std::string> ring_gauge_mesh(const RingGauge& ring);

}  // namespace g31::parts

#pragma once

#include <Eigen/Core>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"
#include "parts/geometry/sphere.h"

namespace g31::parts {

/// Where a part stands on the machine.
struct Placement {
  Point p_M_at = Point::Zero();      ///< mm, machine frame: the origin of the part frame P
  Point rotate_deg = Point::Zero();  ///< about the machine's X, then its Y, then its Z direction
  double growth = 0.0;               ///< by how much each unit of length is longer: warmth
};

/// The rotation that takes directions in P to directions in M.  Multiples of 90 degrees are exact:
/// their entries are 0 and +-1.
Eigen::Matrix3d rotation_to_machine(const Placement& placement);

/// The mesh in the machine frame.  Without rotation and growth the shape is not touched by
/// arithmetic: only p_M_at is added (one rounding a coordinate), and at the origin nothing changes
/// at all.
Mesh placed_mesh(const Mesh& mesh_P, const Placement& placement);

/// A sphere in the machine frame, by the same arithmetic.
Sphere placed_sphere(const Sphere& sphere_P, const Placement& placement);

}  // namespace g31::parts

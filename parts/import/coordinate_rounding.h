#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// The magnitude of the coordinate of a mesh that is furthest out, in its own unit; 0 of one whose
/// coordinates float32 does not hold: it is refused.
inline double furthest_of(const Mesh& mesh) {
  double furthest = 0.0;
  for (const Point& vertex : mesh.vertices) {
    furthest = std::max(furthest, vertex.cwiseAbs().maxCoeff());
  }
  return furthest < static_cast<double>(std::numeric_limits<float>::max()) ? furthest : 0.0;
}

/// Half a step of float32 at that coordinate.
inline double rounding_of(const Mesh& mesh) {
  const double furthest = furthest_of(mesh);
  return furthest > 0.0
             ? 0.5 * std::ldexp(1.0, std::ilogb(furthest) + 1 - std::numeric_limits<float>::digits)
             : 0.0;
}

}  // namespace g31::parts

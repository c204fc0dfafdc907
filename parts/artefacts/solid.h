#pragma once

#include <cstddef>
#include <span>

#include "parts/artefacts/polygon.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

// Closed meshes, consistently oriented with their normals out of the material.

/// Turns a profile about Z; every turn is a regular polygon of `sides` (tangent_polygon).
/// @param profile  points (distance from the axis >= 0, z), the material to the right of the way;
///                 a profile that begins and ends on the axis is a solid without a hole, another
///                 one is closed from its last point to its first
Mesh revolved(std::span<const Point2> profile, std::size_t sides);

/// Draws an outline of the plane XZ along Y, from -0.5 * width to +0.5 * width.
/// @param outline  corners (x, z) of a simple polygon, the material to the left of the way
Mesh extruded(std::span<const Point2> outline, double width);

}  // namespace g31::parts

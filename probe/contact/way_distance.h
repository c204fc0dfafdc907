#pragma once

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"

namespace g31::probe {

/// How near a straight way comes to a mesh, mm: 0 where it goes through; infinite without
/// triangles.
///
/// The distance from a triangle is a convex function of the place on the way: its least is found by
/// golden sections; triangles that are far are left out by their distances at both ends, which
/// change by no more than the way.  As long as the mesh is large; nothing is kept. Accuracy:
/// kWayDistanceErrorMm for ways and coordinates up to 1000 mm.
double distance_of_way(const parts::Mesh& mesh, const Point& p_from, const Point& p_to);

inline constexpr double kWayDistanceErrorMm = 1e-6;

}  // namespace g31::probe

#pragma once

#include <vector>

#include "parts/geometry/mesh.h"

namespace g31::picture {

struct Segment {
  Point p_from;
  Point p_to;
};

/// What a drawing shows as the edges of a body: where the surface bends by more than an angle,
/// where it ends, and where more than two facets meet.  By rising numbers of their vertices, each
/// once.
/// @param angle_deg  0 to 180
std::vector<Segment> feature_edges(const parts::Mesh& mesh, double angle_deg = 20.0);

}  // namespace g31::picture

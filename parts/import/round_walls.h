#pragma once

#include <cstddef>
#include <vector>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// The triangles of a face of an upright cylinder.
struct RoundWall {
  Point axis_at = Point::Zero();  ///< a point on the axis, which is parallel to Z
  double radius_mm = 0.0;
  std::size_t first = 0;  ///< its triangles are those from here
  std::size_t last = 0;   ///< up to here, this one left out
};

/// How far the facets beside the extremes of a round wall in X and Y may be from it.
inline constexpr double kSagittaAtExtremesMm = 2e-7;

/// Puts corners at the extremes of round walls in X and Y and makes the facets beside them finer,
/// the nearer the finer: a ball that comes along X or Y through the axis touches such a wall within
/// kSagittaAtExtremesMm of where it truly is, as long as it is smaller than nine tenths of the
/// hole. In other directions the facets are as they were.
///
/// A wall whose facets do not all reach from its lower to its upper edge stays as it is.
void refine_round_walls(Mesh& mesh, const std::vector<RoundWall>& walls);

}  // namespace g31::parts

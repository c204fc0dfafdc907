#pragma once

#include "parts/features/removed_volume.h"

namespace g31::parts {

/// Puts upright cylinders in the place of the facets of a mesh that stand for them: plane walls
/// side by side, three or more, none of them over more than 30 deg, whose corners lie on one circle
/// within kSameCircleMm, seen from above.
///
/// Accuracy: places of axes and radii are rounded to 1e-4 mm, for meshes have hardly more digits.
void find_round_walls(RemovedVolume& volume);

inline constexpr double kSameCircleMm = 1e-3;

}  // namespace g31::parts

#pragma once

#include <vector>

#include "parts/features/feature.h"
#include "parts/features/removed_volume.h"

namespace g31::parts {

// Two places are the same within kSamePlaceMm, two directions within kSameDirection (rad).
inline constexpr double kSamePlaceMm = 1e-6;
inline constexpr double kSameDirection = 1e-7;

/// How far a plane through rounded corners may be off, in roundings: it is drawn on from facets
/// that are shorter than the face.
inline constexpr double kFaceErrorInRoundings = 8.0;

/// Names what was cut out of a block: Murase's eight kinds by their open sides, turned about Z too,
/// with corner radii, with chamfers at the upper edge and rounded edges of the floor.  What stands
/// free in it, round or a rectangle, is a boss or a rib, from the floor around it to its top; where
/// a volume is open on all four sides, it is all that is found.
///
/// Walls are upright and stand at right angles to each other; two facing ones make an extent of
/// `own`.  A side counts as open where nothing of the product is on it.  A volume with islands of
/// other shapes, with inclined walls, with an outline that is no rectangle, or with openings of
/// none of the kinds is unknown, for a reason that a machinist can follow.
///
/// Accuracy: boxes as those of the faces, rounded to 1e-9 mm.
RecognisedPart recognise(const Box& stock_P, const std::vector<RemovedVolume>& volumes);

}  // namespace g31::parts

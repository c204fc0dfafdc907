#pragma once

#include <optional>
#include <vector>

#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// What a circle travelled in both directions says of the two together, mm.
struct CircleDirections {
  double hysteresis = 0.0;  ///< the largest difference of their radii at one angle
  double mean = 0.0;        ///< the mean of both radii over the angle, less the reference's
};

/// ISO 230-4: hysteresis H and mean bi-directional radial deviation D.  Radii are taken from the
/// centre of the reference and averaged over angles of 0.1 degree, of short records up to 10
/// degrees; angles that only one direction passes do not count.
/// @returns nothing when no angle was passed in both directions
std::optional<CircleDirections> compare_directions(const PlaneSamples& samples,
                                                   const std::vector<CircleTurn>& turns,
                                                   const Circle& reference);

}  // namespace g31::metrology

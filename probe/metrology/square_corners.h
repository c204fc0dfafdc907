#pragma once

#include <cstddef>
#include <optional>

#include "probe/metrology/plane_samples.h"
#include "probe/metrology/square_path.h"

namespace g31::metrology {

/// Where a path crosses the diagonal of a square's corner, mm.
struct CornerCrossing {
  double error = 0.0;   ///< beyond the corner, negative inside
  double unseen = 0.0;  ///< as `SquareEvaluation::corner_unseen`
};

/// What of a record is looked at, and how finely it is written.
struct CornerRecord {
  PlaneSamples samples;
  SampleRange range;
  double resolution = 0.0;  ///< one step of the last digit, mm
};

/// Of several crossings the one furthest from the corner; where there is none, the sample that is
/// nearest on the diagonal.  A record that begins and ends about the corner is taken to go on
/// there.
/// @param corner  0 to 3, from +X +Y counter-clockwise
std::optional<CornerCrossing> corner_crossing(const CornerRecord& record, const Square& square,
                                              std::size_t corner);

}  // namespace g31::metrology

#pragma once

#include <optional>
#include <vector>

#include "probe/metrology/circle_errors.h"
#include "probe/metrology/circle_ranges.h"
#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// Ways that lead into a circle hardly run near it for longer, rad.
inline constexpr double kLongestLead = 45.0 * kDegree;

/// From where to where residuals lie, mm.
struct ResidualBand {
  double least = 0.0;
  double greatest = 0.0;
};

/// How far off what errors leave a path on the circle may be.
struct Expectation {
  CircleErrors errors;
  ReversalWindows windows;
  ResidualBand described;     ///< where the model describes the path
  ResidualBand at_reversals;  ///< in the windows behind reversals and 2 degrees before them
  double scatter = 0.0;       ///< of residuals, where the model describes the path, mm
};

/// The middle of a piece: all but `margin` at either end, or a quarter.
CircleTurn core_of(const PlaneSamples& samples, const CircleTurn& turn, const Circle& circle,
                   double margin);

/// What the middle of parts, all but 45 degrees at either end, leads to expect.  Other places are
/// as far off within 4 times the scatter and, at reversals, within twice the width of what was seen
/// there.
Expectation expectation_of(const PlaneSamples& samples, const std::vector<CircleTurn>& parts,
                           const CircleErrors& errors, const ReversalWindows& windows);

/// How far a part of a piece may grow, and how much further off than expected it may be meanwhile.
struct Growth {
  double angle = 0.0;  ///< rad
  double more = 0.0;   ///< mm
};

/// The part of a piece that is as expected, from the middle of what is known of it to where that
/// ends and grows.  An end that is further off goes, back to where the path is on the circle within
/// the scatter or crosses it; what is off at a reversal and back behind it is a spike and stays.
/// nullopt: most of the middle is further off.
/// @param known  a part of the piece
std::optional<CircleTurn> expected_part(const PlaneSamples& samples, const CircleTurn& turn,
                                        const CircleTurn& known, const Expectation& expectation,
                                        const Growth& growth);

}  // namespace g31::metrology

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"

namespace g31::analysis {

/// How a sheet has a control read numbers without a decimal point.
struct PointReading {
  bool counts_increments = true;  ///< parameter 3401.0 is off
  fanuc::WordScale scale;
};

/// A number that most likely has lost its decimal point.
struct LostPoint {
  syntax::ShortSpan where;
  std::string message;
  std::string remedy;
};

/// Letters of a block whose whole numbers count least increments.
/// @param acting  the code that takes the words of the block for itself; nullptr: none
/// @param drills  K of the block counts holes
std::string_view letters_with_point(const fanuc::GCode* acting, bool drills);

/// Whole numbers that come to less than a millimetre, a degree or 10 mm/min, for the control counts
/// least increments where there is no decimal point: `X10` is 0.01 mm.  Whoever writes in
/// increments on purpose seldom writes so small ones.
/// @param letters  of letters_with_point(), or of arguments
std::vector<LostPoint> lost_points(const fanuc::BlockWords& words, std::string_view letters,
                                   const fanuc::Profile& profile, const PointReading& reading);

}  // namespace g31::analysis

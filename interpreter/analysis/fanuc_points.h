#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/syntax/tree.h"

namespace g31::analysis {

/// How a sheet has a control read numbers without a decimal point.
struct PointReading {
  bool counts_increments = true;  ///< parameter 3401.0 is off
  bool has_fine_feed = false;     ///< parameter 1403.0 is on
  fanuc::WordScale scale;
};

/// What the words of a block are read by.
struct PointedBlock {
  const fanuc::GCode* acting = nullptr;  ///< takes the words for itself; nullptr: none
  bool drills = false;                   ///< in a canned cycle
  bool calls = false;                    ///< they are arguments of G65 or G66
};

/// A number that most likely has lost its decimal point.
struct LostPoint {
  syntax::ShortSpan where;
  std::string message;
  std::string remedy;
};

/// Whole numbers that come to less than a millimetre, a degree, 0.1 s or 10 mm/min, for the control
/// counts least increments where there is no decimal point: `X10` is 0.01 mm.  Whoever writes in
/// increments on purpose seldom writes so small ones.
std::vector<LostPoint> lost_points(const fanuc::BlockWords& words, const PointedBlock& block,
                                   const fanuc::Profile& profile, const PointReading& reading);

/// Whether a program is written in least increments throughout: none of its lengths has a decimal
/// point, and some are a millimetre and more.
bool is_in_increments(const syntax::Tree& tree, const PointReading& reading);

}  // namespace g31::analysis

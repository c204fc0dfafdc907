#pragma once

#include <optional>
#include <set>
#include <vector>

#include "interpreter/analysis/fanuc_constants.h"
#include "interpreter/analysis/fanuc_points.h"

namespace g31::analysis {

/// What decides beside the words of a block itself how they are read.
struct WordReading {
  std::set<int> calling_codes;     ///< G codes that the sheet makes macro calls
  bool every_block_calls = false;  ///< G66.1 is in one of the programs, and lasts in what it calls
  PointReading points;
  bool in_increments = false;  ///< the file of the program is, as is_in_increments() says
};

/// What is found in the words of a block.
struct WordFindings {
  std::optional<WrongConstant> wrong;  ///< ends every run of the block
  std::vector<LostPoint> lost_points;
};

/// Whether a G code may call a macro: the sheet says so, also in the place of a maker's own code,
/// or g31 does not have it, and it may be an option of the real control.
bool g_code_may_call(double code, const fanuc::Profile& profile, const WordReading& reading);

/// Judges the numbers of NC blocks by what a run takes there, in whatever state it comes to them.
///
/// Words that may be arguments of a macro are not judged: those of a block that begins with an M
/// code or has a G code that not all controls have, for the set-up sheet says what these call.
class FanucWords {
 public:
  /// All must outlive it.
  FanucWords(const fanuc::CompiledProgram& program, const fanuc::Profile& profile,
             const WordReading& reading);

  /// To be asked of all blocks of words in their order.  What only a run knows is not found.
  WordFindings judge(const syntax::Block& block);

 private:
  const fanuc::CompiledProgram& program_;
  const fanuc::Profile& profile_;
  const WordReading& reading_;
  bool takes_data_ = false;  ///< from G10 L3 or L50 to G11
};

/// Whether a program has G66.1.
bool lets_every_block_call(const syntax::Tree& tree);

}  // namespace g31::analysis

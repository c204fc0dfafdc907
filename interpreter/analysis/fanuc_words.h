#pragma once

#include <optional>
#include <set>

#include "interpreter/analysis/fanuc_constants.h"

namespace g31::analysis {

/// What calls macros beside the words of a block itself: their words are arguments then.
struct MacroCallers {
  std::set<int> codes;       ///< G codes that the sheet makes macro calls
  bool every_block = false;  ///< G66.1 stands in one of the programs, and lasts in what it calls
};

/// Judges the numbers of NC blocks by what a run takes there, in whatever state it comes to them.
///
/// Words that may be arguments of a macro are not judged: those of a block that begins with an M
/// code or has a G code that not all controls have, for the set-up sheet says what these call.
class FanucWords {
 public:
  /// All must outlive it.
  FanucWords(const fanuc::CompiledProgram& program, const fanuc::Profile& profile,
             const MacroCallers& callers);

  /// To be asked of all blocks of words in their order.
  /// @returns what ends every run of the block; nullopt: nothing, or only a run knows
  std::optional<WrongConstant> wrong_in(const syntax::Block& block);

 private:
  const fanuc::CompiledProgram& program_;
  const fanuc::Profile& profile_;
  const MacroCallers& callers_;
  bool takes_data_ = false;  ///< from G10 L3 or L50 to G11
};

/// Whether a program has G66.1.
bool lets_every_block_call(const fanuc::CompiledProgram& program);

}  // namespace g31::analysis

#pragma once

#include <optional>

#include "interpreter/analysis/fanuc_constants.h"

namespace g31::analysis {

/// Judges the numbers of NC blocks by what a run takes there, in whatever state it comes to them.
///
/// Words that may be arguments of a macro are not judged: those of a block that begins with an M
/// code or has a G code that not all controls have, for the set-up sheet says what these call.
class FanucWords {
 public:
  /// Both must outlive it.
  FanucWords(const fanuc::CompiledProgram& program, const fanuc::Profile& profile);

  /// To be asked of all blocks of words in their order.
  /// @returns what ends every run of the block; nullopt: nothing, or only a run knows
  std::optional<WrongConstant> wrong_in(const syntax::Block& block);

 private:
  const fanuc::CompiledProgram& program_;
  const fanuc::Profile& profile_;
  bool every_block_calls_ = false;  ///< G66.1: then all words are arguments
  bool takes_data_ = false;         ///< from G10 L3 or L50 to G11
};

}  // namespace g31::analysis

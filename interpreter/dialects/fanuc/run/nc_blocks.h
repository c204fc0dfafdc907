#pragma once

#include <string>

#include "interpreter/dialects/fanuc/run/word_calls.h"

namespace g31::fanuc {

/// Blocks of NC words: what they call, and what they do.
class NcBlocks {
 public:
  /// All must outlive it.
  NcBlocks(CallStack& stack, Control& control, CalledPrograms& programs, Jumps& jumps);
  /// Its parts know each other by their places.
  NcBlocks(const NcBlocks&) = delete;
  NcBlocks& operator=(const NcBlocks&) = delete;

  MaybeFailure run(const Step& step);

 private:
  MaybeFailure modal_call();
  MaybeFailure end_of_call(source::Location where);
  MaybeFailure own_words(source::Location where);
  [[nodiscard]] MaybeFailure skip_check(source::Location where);
  [[nodiscard]] MaybeFailure ask_for_key(source::Location where);
  [[nodiscard]] std::string prompt() const;
  MaybeFailure program_codes(source::Location where);
  void stop_program(int m, source::Location where);

  CallStack& stack_;
  Control& control_;
  RunningWords running_;
  MacroArguments arguments_;
  Levels levels_;
  Subprograms subprograms_;
  MacroCalls macros_;
  WordCalls calls_;
};

}  // namespace g31::fanuc

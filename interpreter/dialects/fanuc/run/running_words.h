#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/run/call_stack.h"
#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/runtime/missed_touches.h"

namespace g31::fanuc {

/// The words of the running NC block, worked out.
class RunningWords {
 public:
  /// Both must outlive it.
  RunningWords(const CallStack& stack, Control& control) : stack_(stack), control_(control) {}

  MaybeFailure read(const Step& step);
  [[nodiscard]] const BlockWords& words() const { return words_; }
  /// Leaves out G67, and what is of M99: itself, P and L.
  void leave_out_end_of_call(bool returns);

  /// What they read of skip moves without a signal, by where they stand.
  using Readings = std::vector<std::pair<std::uint32_t, runtime::MissedTouches::Reading>>;
  [[nodiscard]] const Readings& readings() const { return readings_; }

 private:
  MaybeFailure read_plain(const syntax::Block& block, std::span<const syntax::Word> words);
  MaybeFailure read_all(const CompiledProgram& program, std::span<const syntax::Word> words);
  bool skips_rest(const syntax::Word& word);
  [[nodiscard]] const Frame& frame() const { return stack_.frame(); }

  const CallStack& stack_;
  Control& control_;
  BlockWords words_;
  Readings readings_;
};

/// What the words of a block do, calls apart.
MaybeFailure execute_words(Control& control, const BlockWords& words, source::Location where);

}  // namespace g31::fanuc

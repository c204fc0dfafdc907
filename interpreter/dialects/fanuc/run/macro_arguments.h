#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/run/running_words.h"

namespace g31::fanuc {

/// Of P, where it is an argument.
inline constexpr std::size_t kVariableOfP = 16;

/// What a word passes to a macro: without a point it counts least increments (MB-196).
double argument_value(const Control& control, const EvaluatedWord& word);

/// What words of a call pass to a macro.
class MacroArguments {
 public:
  /// All must outlive it.
  MacroArguments(const CallStack& stack, const RunningWords& running, Control& control)
      : stack_(stack), running_(running), control_(control) {}

  /// Puts arguments among locals.  I J K may come again: then they belong to the next triple
  /// (specification II, MB-192, MB-194), unless parameter 6008.7 says specification I only.
  MaybeFailure put_among(Variables::Locals& locals, std::span<const EvaluatedWord> arguments);
  /// The locals of the level that begins hold what the arguments were made of.
  void follow();
  /// The same of a modal call, which keeps them until it calls.
  /// @param which  of the modal calls in force
  void keep_for_modal_call(std::size_t which);
  void follow_modal_call(std::size_t which);
  /// A macro that an M code calls finds them in #4101 to #4126.
  void keep_words();

 private:
  const CallStack& stack_;
  const RunningWords& running_;
  Control& control_;
  void assign_to(std::size_t depth);

  /// What the arguments are made of of skip moves without a signal, by variable.
  std::vector<std::pair<std::int32_t, runtime::MissedTouches::Reading>> made_of_;
};

}  // namespace g31::fanuc

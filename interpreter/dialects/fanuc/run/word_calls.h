#pragma once

#include "interpreter/dialects/fanuc/run/macro_calls.h"
#include "interpreter/dialects/fanuc/run/subprograms.h"

namespace g31::fanuc {

/// Which word of a block calls what.
class WordCalls {
 public:
  /// All must outlive it.
  WordCalls(const CallStack& stack, Control& control, const RunningWords& running,
            MacroCalls& macros, Subprograms& subprograms)
      : stack_(stack),
        control_(control),
        words_(running.words()),
        macros_(macros),
        subprograms_(subprograms) {}

  /// Calls what a word of the block calls.  @returns whether there was such a word
  Result<bool, Failure> call_in_block();
  /// Whether G67 stands in the block, or M99, which ends the program behind the other words.
  [[nodiscard]] bool ends_call() const { return cancels_ || returns_; }
  [[nodiscard]] bool returns() const { return returns_; }

 private:
  Result<bool, Failure> call_by_g(const EvaluatedWord& word, bool every_block);
  Result<bool, Failure> call_by_m(const EvaluatedWord& word);
  Result<bool, Failure> call_by_address(const EvaluatedWord& word);
  /// What a letter calls; program 0: nothing.
  [[nodiscard]] const AddressCall& address_call(char letter) const {
    return control_.code_calls.by_address[static_cast<std::size_t>(letter - 'A')];
  }
  [[nodiscard]] bool may_call(CalledBy by) const;
  [[nodiscard]] const Frame& frame() const { return stack_.frame(); }

  const CallStack& stack_;
  Control& control_;
  const BlockWords& words_;
  MacroCalls& macros_;
  Subprograms& subprograms_;
  bool cancels_ = false;
  bool returns_ = false;
};

}  // namespace g31::fanuc

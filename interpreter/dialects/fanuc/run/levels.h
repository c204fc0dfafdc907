#pragma once

#include <cstddef>

#include "interpreter/dialects/fanuc/run/call_stack.h"
#include "interpreter/dialects/fanuc/state/control.h"

namespace g31::fanuc {

/// Into a program and out of it, with all that goes along: local variables, modal calls, and who
/// listens.
class Levels {
 public:
  /// Both must outlive it.
  Levels(CallStack& stack, Control& control) : stack_(stack), control_(control) {}

  MaybeFailure enter(const Entry& entry);
  /// The program of this level once more from its beginning: a call of its own, up and down again.
  void repeat();
  /// Back to the caller.
  void leave();

  [[nodiscard]] CallStack& stack() { return stack_; }

 private:
  void arrive();
  Frame& frame() { return stack_.frame(); }

  CallStack& stack_;
  Control& control_;
};

}  // namespace g31::fanuc

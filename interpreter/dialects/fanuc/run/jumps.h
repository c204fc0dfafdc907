#pragma once

#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/dialects/fanuc/run/call_stack.h"
#include "interpreter/dialects/fanuc/state/control.h"

namespace g31::fanuc {

/// Where a program goes on that does not go on at its next step.
class Jumps {
 public:
  /// All must outlive it.
  Jumps(CallStack& stack, ProgramLibrary& library, Control& control)
      : stack_(stack), library_(library), control_(control) {}

  /// GOTO.
  MaybeFailure jump(const Step& step);
  /// A level, the running one or one that waits, goes on at N `sequence`; `missing` is what it
  /// means when there is no such block.
  MaybeFailure go_to(Frame& level, int sequence, Failure missing);
  /// A jump is ahead: the whole program of a level must be known.
  MaybeFailure keep_whole(Frame& level);
  /// Goes on in the next window of a long program, or says that the program has no end.
  MaybeFailure behind_last_step();

 private:
  MaybeFailure arrive_at(Frame& level, syntax::Index step);
  Frame& frame() { return stack_.frame(); }

  CallStack& stack_;
  ProgramLibrary& library_;
  Control& control_;
};

}  // namespace g31::fanuc

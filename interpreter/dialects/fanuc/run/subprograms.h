#pragma once

#include <initializer_list>

#include "interpreter/dialects/fanuc/run/called_programs.h"
#include "interpreter/dialects/fanuc/run/jumps.h"
#include "interpreter/dialects/fanuc/run/levels.h"
#include "interpreter/dialects/fanuc/run/running_words.h"

namespace g31::fanuc {

/// Calls that share the caller's local variables, and the ways back: M98, M198, M97, M96, M99.
class Subprograms {
 public:
  /// All must outlive it.
  Subprograms(Control& control, const RunningWords& running, CalledPrograms& programs, Jumps& jumps,
              Levels& levels)
      : control_(control),
        words_(running.words()),
        programs_(programs),
        jumps_(jumps),
        levels_(levels) {}

  /// M198, or the M code of parameter 6030 (MB-222).
  [[nodiscard]] bool calls_external(int m) const;
  /// M98 P L Q, M198 P: motion of the block first, then the call (MB-213 to MB-217, MB-222).
  MaybeFailure call(const EvaluatedWord& m);
  /// M97 P L: the blocks from N of P on, to M99, as a subprogram of the same text.
  MaybeFailure call_local(const EvaluatedWord& m);
  /// M96 P Q: on at block N of P while input Q is 0.
  MaybeFailure jump_by_input(const EvaluatedWord& m);
  /// An M or T code that parameters make a subprogram call: the other words of the block are
  /// executed first, the code itself is not (MB-210, MB-211).
  MaybeFailure call_by_code(const EvaluatedWord& code, int program_number);
  /// M99 of a block of these words: back to the caller, to block P of it, or to the top of the main
  /// program; L replaces the repeats that are left (MB-218 to MB-221).
  MaybeFailure return_from(const BlockWords& words);

 private:
  Result<Entry, Failure> entry_of(const EvaluatedWord& m);
  MaybeFailure count_in(const EvaluatedWord& p, Entry& entry);
  MaybeFailure find_called(const EvaluatedWord& p, Entry& entry);
  MaybeFailure execute_beside(const EvaluatedWord& call, std::initializer_list<char> arguments);
  MaybeFailure go_to(Frame& level, const EvaluatedWord& p);
  Frame& frame() { return levels_.stack().frame(); }

  Control& control_;
  const BlockWords& words_;
  CalledPrograms& programs_;
  Jumps& jumps_;
  Levels& levels_;
};

}  // namespace g31::fanuc

#pragma once

#include <span>
#include <vector>

#include "interpreter/dialects/fanuc/run/called_programs.h"
#include "interpreter/dialects/fanuc/run/levels.h"
#include "interpreter/dialects/fanuc/run/macro_arguments.h"

namespace g31::fanuc {

/// Calls with arguments: G65, G66, G66.1, and codes that parameters or the sheet make such calls.
class MacroCalls {
 public:
  /// All must outlive it.
  MacroCalls(Control& control, const RunningWords& running, CalledPrograms& programs,
             MacroArguments& arguments, Levels& levels)
      : control_(control),
        words_(running.words()),
        programs_(programs),
        arguments_(arguments),
        levels_(levels) {}

  MaybeFailure call(const EvaluatedWord& code);
  /// A G or M code that parameters or the sheet make a macro call (MB-207, MB-209).  P is an
  /// argument, too: MELDAS, parameter #1241, "macro argument L/P valid".
  MaybeFailure call_by_code(const EvaluatedWord& code, int program_number, CalledBy by);
  /// G66 and G66.1: from the next block on; the block itself calls nothing (MB-203).
  MaybeFailure set_modal(const EvaluatedWord& code);
  MaybeFailure cancel_modal(const EvaluatedWord& code);
  /// The modal call that a motion block of this program sets off.
  MaybeFailure modal_call();
  /// G66.1: the words of the block become arguments, the block itself is not executed (MB-205).
  MaybeFailure every_block_call();

 private:
  MaybeFailure enter(const Entry& entry, std::span<const EvaluatedWord> arguments,
                     Variables::Locals locals = {});
  MaybeFailure codes_before(const EvaluatedWord& code);
  void tell_argument_before(std::span<const EvaluatedWord> arguments, const EvaluatedWord& code);
  Frame& frame() { return levels_.stack().frame(); }

  Control& control_;
  const BlockWords& words_;
  CalledPrograms& programs_;
  MacroArguments& arguments_;
  Levels& levels_;
  std::vector<EvaluatedWord> arguments_of_call_;  ///< kept for its memory
};

}  // namespace g31::fanuc

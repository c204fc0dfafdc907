#pragma once

#include <cstddef>
#include <vector>

#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/dialects/fanuc/run/assignments.h"
#include "interpreter/dialects/fanuc/run/call_stack.h"
#include "interpreter/dialects/fanuc/run/called_programs.h"
#include "interpreter/dialects/fanuc/run/jumps.h"
#include "interpreter/dialects/fanuc/run/nc_blocks.h"
#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/system/control_variables.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/outcome.h"

namespace g31::fanuc {

/// Steps through compiled programs: statements and jumps.  Its parts do what takes more: NcBlocks
/// those of words, and what they command is done in execute/.
class Runner {
 public:
  Runner(const Profile& profile, ProgramLibrary& library, machine::MachinePort& port,
         runtime::Observer& observer);
  /// Its parts know each other by their places.
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  // runner_advance.cc

  /// Stands before the first block; a program that cannot run at all has ended already.
  /// @param listener  outlives the run; nullptr: none
  void begin(const runtime::Budget& budget, runtime::BlockListener* listener);
  /// Goes on to the end, or to the next pause that the listener wants.
  runtime::Advance advance();
  /// What became of the run, which ends here if it has not ended.
  runtime::Outcome finish();

  /// At a pause and behind the end, innermost first.
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const;

  Control& control() { return control_; }
  [[nodiscard]] const Control& control() const { return control_; }
  [[nodiscard]] const CallStack& stack() const { return stack_; }

 private:
  bool refuse_broken(const CompiledProgram& main);
  MaybeFailure come_to_rest(const MaybeFailure& reason);
  void end(const MaybeFailure& failure);
  void start(const CompiledProgram& main);
  runtime::Outcome outcome_of(const Failure& failure);
  [[nodiscard]] std::vector<runtime::CallLevel> levels_from(source::Location innermost) const;
  [[nodiscard]] std::vector<runtime::CallLevel> levels_of(const Failure& failure) const;

  // runner.cc: the loop
  MaybeFailure loop();
  [[nodiscard]] runtime::BlockPlace next_place() const;
  void tell_condition(syntax::BlockKind kind) const;
  bool fast_step(const Step& step, Frame& now);
  MaybeFailure rare_step(const Step& step);
  MaybeFailure bad_block(const Step& step);

  ProgramLibrary& library_;
  ControlVariables system_;
  Control control_;
  CallStack stack_;
  Jumps jumps_;
  CalledPrograms programs_;
  Assignments assignments_;
  NcBlocks blocks_;
  bool has_jumped_ = false;  ///< the IF ... GOTO that has just run
  bool is_paused_ = false;   ///< before the step that comes next
  bool is_over_ = false;     ///< the run; outcome_ says how
  runtime::Outcome outcome_;
};

}  // namespace g31::fanuc

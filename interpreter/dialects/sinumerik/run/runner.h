#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/code/callable_programs.h"
#include "interpreter/dialects/sinumerik/run/call_stack.h"
#include "interpreter/dialects/sinumerik/run/calls.h"
#include "interpreter/dialects/sinumerik/run/functions.h"
#include "interpreter/dialects/sinumerik/run/missed_results.h"
#include "interpreter/dialects/sinumerik/run/procedures.h"
#include "interpreter/dialects/sinumerik/run/shown_value.h"
#include "interpreter/dialects/sinumerik/run/step_machine.h"
#include "interpreter/dialects/sinumerik/run/synchronised_actions.h"
#include "interpreter/dialects/sinumerik/run/system_steps.h"
#include "interpreter/dialects/sinumerik/run/word_steps.h"
#include "interpreter/dialects/sinumerik/run/written_values.h"
#include "interpreter/dialects/sinumerik/state/channel.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/outcome.h"

namespace g31::sinumerik {

/// Steps through compiled programs: blocks and jumps.  Its parts do the steps of each kind; what NC
/// blocks command is done in execute/, what system variables show in system/.
class Runner {
 public:
  Runner(CallablePrograms& programs, machine::MachinePort& port, runtime::Observer& observer);
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

  // run_inspection.cc: at a pause; level 0 is the innermost

  /// None before a run: what is looked at then runs on a level of its own.
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const {
    return has_run_ ? stack_.call_levels() : std::vector<runtime::CallLevel>();
  }
  /// Local variables and parameters, frames apart.
  std::vector<std::pair<std::string, ShownValue>> local_values(std::size_t level);
  /// The value of an expression among the variables of a level.  Nothing of the run changes.
  Result<ShownValue, std::string> evaluate(std::size_t level, const std::string& expression);

  /// Runs `text` on its own, among the variables of the main program.  @returns why it failed
  std::optional<std::string> run_text(const std::string& text);
  /// Why a text is no expression; nullopt: it is one.  Nothing is evaluated.
  std::optional<std::string> wrong_expression(const std::string& expression);
  /// Why a name is none of a variable that may get a number before the run; nullopt: it is one.
  std::optional<std::string> why_no_variable(const std::string& name);
  /// The value of an expression after a run; before it local variables have their first values.
  Result<ShownValue, std::string> value_of(const std::string& expression);

  /// Sets the initial values of a definition file, or runs an INI file.  The outcome of the next
  /// run says what went wrong first.
  void run_before(const CompiledProgram& program);

  Channel& channel() { return channel_; }

 private:
  // runner.cc
  void start(const CompiledProgram& program);
  MaybeFailure loop();
  MaybeFailure heard_loop(runtime::BlockListener& listener);
  MaybeFailure any_step(const Op& op);
  MaybeFailure other_step(const Op& op);
  [[nodiscard]] std::vector<runtime::CallLevel> levels_of(const Failure& failure) const;
  runtime::Outcome outcome_of(const Failure& failure);
  Level& level() { return stack_.level(); }

  // runner_blocks.cc
  [[nodiscard]] bool skips(int which) const;
  [[nodiscard]] runtime::BlockPlace block_place(const Op& op) const;
  bool begins(const Op& op);
  MaybeFailure execute(const Op& op);
  void arrive_at(std::int32_t step);
  bool at_end_of_part(std::int32_t step);

  // The column `handler` of op_codes.def, runner_blocks.cc.
  MaybeFailure block(const Op& op);
  MaybeFailure nc_block(const Op& op);
  MaybeFailure jump_into(const Op& op);
  MaybeFailure jump_to_text(const Op& op);
  MaybeFailure repeat_part(const Op& op);
  MaybeFailure repeat_text(const Op& op);
  MaybeFailure end_program(const Op& op);
  MaybeFailure raise(const Op& op);
  MaybeFailure surplus_end(const Op& op);
  MaybeFailure watch_datum(const Op& op);
  MaybeFailure tell_not_simulated(const Op& op);
  // Those that a part does.
  MaybeFailure call_function(const Op& op) { return functions_.call(op); }
  MaybeFailure procedure(const Op& op) { return procedures_.call(op); }
  MaybeFailure read_system(const Op& op) { return system_.read(op); }
  MaybeFailure write_system(const Op& op) { return system_.write(op); }
  MaybeFailure take_word(const Op& op) { return words_.take_word(op); }
  MaybeFailure take_text_word(const Op& op) { return words_.take_text_word(op); }
  MaybeFailure take_axis_word(const Op& op) { return words_.take_axis_word(op); }
  MaybeFailure take_axis_measuring(const Op& op) { return words_.take_axis_measuring(op); }
  MaybeFailure check_spindle(const Op& op) { return words_.check_spindle(op); }
  MaybeFailure take_spindle_word(const Op& op) { return words_.take_spindle_word(op); }
  MaybeFailure take_group_code(const Op& op) { return words_.take_group_code(op); }
  MaybeFailure take_skip_action(const Op& op) { return words_.take_skip_action(op); }
  MaybeFailure take_synchronised_action(const Op& op) { return actions_.take(op); }
  MaybeFailure find_called(const Op& op) { return calls_.find_called(op); }
  MaybeFailure call(const Op& op) { return calls_.call(op); }
  MaybeFailure return_from(const Op& op) { return calls_.return_from(op); }
  MaybeFailure end_text(const Op& /*op*/) { return calls_.end_text(); }
  MaybeFailure begin_window(const Op& /*op*/) { return calls_.begin_window(); }

  // runner_advance.cc
  MaybeFailure come_to_rest(const MaybeFailure& reason);
  void end(const MaybeFailure& reason);

  // run_inspection.cc
  SynchronisedActions::Among among();
  MaybeFailure run_among(const CompiledProgram& program, std::size_t depth,
                         runtime::BlockListener* listener = nullptr);
  Result<ShownValue, std::string> result_of(const CompiledProgram& program, std::size_t depth);
  [[nodiscard]] const CompiledProgram& home(std::size_t depth) const;
  [[nodiscard]] std::size_t depth_of(std::size_t level) const;

  CallablePrograms& programs_;
  Channel channel_;
  CallStack stack_;
  StepMachine machine_;
  Operands& operands_;
  MissedResults missed_;
  CalledPrograms called_;
  Calls calls_;
  WordSteps words_;
  SynchronisedActions actions_;
  FunctionCaller functions_;
  ProcedureCaller procedures_;
  SystemSteps system_;
  WrittenValues written_;
  /// What evaluate() compiled, by the program whose variables it names.
  std::map<std::pair<const CompiledProgram*, std::string>, const CompiledProgram*> expressions_;
  bool is_paused_ = false;  ///< before the block that comes next
  bool is_over_ = false;    ///< the run; outcome_ says how
  runtime::Outcome outcome_;
  bool has_run_ = false;  ///< the main program
  std::optional<runtime::Outcome> early_failure_;
};

}  // namespace g31::sinumerik

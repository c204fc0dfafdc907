#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/system/control_variables.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/outcome.h"

namespace g31::fanuc {

enum class CallKind {
  Main,
  Subprogram,  ///< M98: shares the caller's locals
  Macro,       ///< G65: locals of its own
};

/// What called a program; in one that a code called, such codes are ordinary (MB-208).
enum class CalledBy {
  Program,
  GCode,
  Address,  ///< M, T, S, B and the like
};

/// Where a called program comes from.
enum class Storage {
  Memory,
  External  ///< M198
};

/// G66 or G66.1 in force.
struct ModalCall {
  const CompiledProgram* program = nullptr;
  int repeats = 1;
  bool every_block = false;  ///< G66.1: each NC block becomes a call
  /// The arguments at first; after a call of G66 what its macro left in them (MB-204).
  Variables::Locals locals;
};

/// How a program is entered.
struct Entry {
  const CompiledProgram* program = nullptr;
  CallKind kind = CallKind::Macro;
  CalledBy by = CalledBy::Program;
  int repeats = 1;
  syntax::Index first_step = 0;
  Storage storage = Storage::Memory;
};

/// One level of the call stack.
struct Frame {
  const CompiledProgram* program = nullptr;
  syntax::Index step = 0;  ///< the next to execute
  syntax::Index current = 0;
  syntax::Index first_step = 0;  ///< where each repeat begins
  CallKind kind = CallKind::Main;
  CalledBy by = CalledBy::Program;
  Storage storage = Storage::Memory;
  int repeats_left = 0;
  /// Modal calls that motion in this program sets off, the last first; inside a modal call the
  /// outer ones are left (MB-204).
  std::vector<std::shared_ptr<ModalCall>> modal_calls;
  std::shared_ptr<ModalCall> of_modal_call;  ///< the one that called this program, if any
};

/// Steps through compiled programs: statements, jumps and calls.  NC blocks go to execute/.
class Runner {
 public:
  Runner(const Profile& profile, ProgramLibrary& library, machine::MachinePort& port,
         runtime::Observer& observer);

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
  /// Which level of local variables a level of calls has; 0: the main program's.
  /// @param level  0: the innermost
  [[nodiscard]] std::size_t locals_of(std::size_t level) const;

 private:
  bool refuse_broken(const CompiledProgram& main);
  MaybeFailure come_to_rest(const MaybeFailure& reason);
  void end(const MaybeFailure& failure);
  void start(const CompiledProgram& main);

  // runner.cc: the loop
  MaybeFailure loop();
  [[nodiscard]] runtime::BlockPlace next_place() const;
  void tell_condition(syntax::BlockKind kind) const;
  bool fast_step(const Step& step, Frame& now);
  MaybeFailure rare_step(const Step& step);
  MaybeFailure set_names(const Step& step);
  MaybeFailure bad_block(const Step& step);
  MaybeFailure assign(const Step& step);
  std::optional<Cell> looked_at(std::int32_t number);
  void tell_write(std::int32_t number, Cell before, Cell written);
  MaybeFailure assigned_system_variable(int number, double value);
  MaybeFailure jump(const Step& step);
  MaybeFailure output(const Step& step);  // runner_output.cc
  MaybeFailure open_or_close(OutputStatement statement);
  MaybeFailure refused_output(OutputStatement statement, syntax::ShortSpan block);
  MaybeFailure behind_last_step();
  MaybeFailure keep_whole(Frame& frame);
  MaybeFailure arrive_at(Frame& frame, syntax::Index step);
  MaybeFailure go_to(Frame& frame, int sequence, Failure missing);

  // runner_words.cc: NC blocks
  MaybeFailure nc_block(const Step& step);
  MaybeFailure evaluate_words(const Step& step);
  bool skips_rest(const syntax::Word& word);
  MaybeFailure execute(const BlockWords& words, source::Location where);
  MaybeFailure execute_beside(const EvaluatedWord& call, std::initializer_list<char> arguments);
  MaybeFailure plain_block(source::Location where);
  [[nodiscard]] MaybeFailure skip_check(source::Location where);
  MaybeFailure program_stop(int m, source::Location where);

  // runner_calls.cc: which word calls what
  Result<bool, Failure> call_in_block();
  Result<bool, Failure> call_by_g(const EvaluatedWord& word, bool every_block);
  Result<bool, Failure> call_by_m(const EvaluatedWord& word);
  Result<bool, Failure> call_by_address(const EvaluatedWord& word);
  MaybeFailure macro_call(const EvaluatedWord& code);
  MaybeFailure set_modal_call(const EvaluatedWord& code);
  MaybeFailure cancel_modal_call(const EvaluatedWord& code);
  MaybeFailure modal_call();
  MaybeFailure every_block_call();
  MaybeFailure enter_macro(const Entry& entry, std::span<const EvaluatedWord> arguments,
                           const Variables::Locals& given = {});
  MaybeFailure code_macro(const EvaluatedWord& code, int program, CalledBy by);
  MaybeFailure code_subprogram(const EvaluatedWord& code, int program);
  void follow_arguments();
  void take_reports();
  Result<Variables::Locals, Failure> with_arguments(Variables::Locals locals,
                                                    std::span<const EvaluatedWord> arguments);
  const CompiledProgram* program_of(int number);
  Result<const CompiledProgram*, Failure> called_program(const EvaluatedWord& p);
  Result<int, Failure> repeats() const;
  void keep_words();
  [[nodiscard]] double argument_value(const EvaluatedWord& word) const;
  [[nodiscard]] bool may_call(CalledBy by) const;

  // runner_levels.cc: into a program and out of it
  MaybeFailure subprogram_call(const EvaluatedWord& m);
  Result<Entry, Failure> subprogram_entry(const EvaluatedWord& m);
  [[nodiscard]] bool calls_external(int m) const;
  MaybeFailure local_call(const EvaluatedWord& m);
  MaybeFailure jump_by_input(const EvaluatedWord& m);
  MaybeFailure return_from_call();
  MaybeFailure enter(const Entry& entry);
  [[nodiscard]] int levels(CallKind kind) const;

  // runner_failure.cc: what became of it
  Failure from_evaluation();
  runtime::Outcome outcome_of(const Failure& failure);
  [[nodiscard]] source::Location location(syntax::ShortSpan span) const;
  [[nodiscard]] source::Location location_of(const Frame& frame) const;
  [[nodiscard]] std::vector<runtime::CallSite> call_stack() const;
  static std::string name_of(const CompiledProgram& program);

  Frame& frame() { return frames_.back(); }

  ProgramLibrary& library_;
  ControlVariables system_;
  Control control_;
  std::vector<Frame> frames_;
  BlockWords words_;
  /// What the words of the block read of skip moves without a signal, by where they stand; and what
  /// the arguments of a call are made of, by variable.
  std::vector<std::pair<std::uint32_t, runtime::MissedTouches::Reading>> read_by_words_;
  std::vector<std::pair<std::int32_t, runtime::MissedTouches::Reading>> read_by_arguments_;
  bool has_jumped_ = false;  ///< the IF ... GOTO that has just run
  bool ended_ = false;       ///< the program
  bool is_paused_ = false;   ///< before the step that comes next
  bool is_over_ = false;     ///< the run; outcome_ says how
  runtime::Outcome outcome_;
};

}  // namespace g31::fanuc

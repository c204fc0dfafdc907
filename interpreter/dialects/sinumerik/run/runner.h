#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/code/callable_programs.h"
#include "interpreter/dialects/sinumerik/code/value_limits.h"
#include "interpreter/dialects/sinumerik/state/channel.h"
#include "interpreter/dialects/sinumerik/state/level.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/outcome.h"

namespace g31::sinumerik {

struct Block;
struct SystemAccess;

/// A value as --print shows it.
struct ShownValue {
  Type type = Type::None;
  double number = 0.0;
  std::string text;
};

/// The same as reports show it: an axis by its name.
runtime::ShownValue shown_value(const ShownValue& value);

/// The name under which a program's file is kept: the path without its folders; "" when the path
/// names none, or leads out of the control's memory.
std::string file_name(std::string_view path);

/// Steps through compiled programs: numbers, texts, jumps and calls.  What NC blocks command is
/// done in execute/, what system variables show in system/.
class Runner {
 public:
  Runner(CallablePrograms& programs, machine::MachinePort& port, runtime::Observer& observer);

  // runner_advance.cc

  /// Stands before the first block; a program that cannot run at all has ended already.
  /// @param listener  outlives the run; nullptr: none
  void begin(const runtime::Budget& budget, runtime::BlockListener* listener);
  /// Goes on to the end, or to the next pause that the listener wants.
  runtime::Advance advance();
  /// What became of the run, which ends here if it has not ended.
  runtime::Outcome finish();

  // run_inspection.cc: at a pause; level 0 is the innermost

  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const;
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
  using Arguments = std::span<const Argument>;

  // runner.cc
  [[nodiscard]] bool skips(int which) const;
  [[nodiscard]] runtime::BlockPlace block_place(const Op& op) const;
  void start(const CompiledProgram& program);
  MaybeFailure begin_window(const Op& op);
  MaybeFailure take_no_arguments();
  MaybeFailure loop();
  MaybeFailure other_step(const Op& op);
  bool begins(const Op& op);
  MaybeFailure block(const Op& op);
  MaybeFailure nc_block(const Op& op);
  void arrive_at(std::int32_t step);
  MaybeFailure jump_into(const Op& op);
  MaybeFailure jump_to_text(const Op& op);
  bool at_end_of_part(std::int32_t step);
  MaybeFailure repeat_part(const Op& op);
  MaybeFailure raise(const Op& op);
  MaybeFailure surplus_end(const Op& op);
  MaybeFailure take_spindle_word(const Op& op);
  MaybeFailure take_group_code(const Op& op);
  Level& level() { return *levels_[depth_]; }
  void use_level();
  runtime::Outcome outcome_of(const Failure& failure);
  [[nodiscard]] std::size_t shown_level() const;
  [[nodiscard]] std::vector<runtime::CallSite> calls_of(std::size_t which) const;
  [[nodiscard]] source::Location place_of_call(std::size_t which) const;
  [[nodiscard]] source::Location here() const;
  MaybeFailure from_step();

  // runner_advance.cc
  MaybeFailure come_to_rest(const MaybeFailure& reason);
  void end(const MaybeFailure& reason);

  // run_inspection.cc
  MaybeFailure run_among(const CompiledProgram& program, std::size_t depth,
                         runtime::BlockListener* listener = nullptr);
  Result<ShownValue, std::string> result_of(const CompiledProgram& program, std::size_t depth);
  [[nodiscard]] const CompiledProgram& home(std::size_t depth) const;
  [[nodiscard]] std::size_t depth_of(std::size_t level) const;

  // run_writes.cc
  struct WrittenValue;
  MaybeFailure heard_loop(runtime::BlockListener& listener);
  const Op& take_step();
  MaybeFailure any_step(const Op& op);
  std::vector<WrittenValue> written_by(const Op& op);
  std::vector<WrittenValue> written_by_number_step(const Op& op);
  std::vector<WrittenValue> written_to_arguments(const Op& op);
  std::vector<WrittenValue> elements(std::int32_t which, std::int32_t first, std::int32_t count);
  std::string system_name(const Op& op);
  runtime::ShownValue system_value(const Op& op);
  runtime::ShownValue value_now(const WrittenValue& written, const Op& op);

  // run_missed.cc
  void follow(const Op& op);
  void follow_function(const Op& op);
  void follow_read(const Op& op);
  const double& element(const Op& op);
  void use_measured();
  void forget(std::span<const double> cells);
  void end_missed();

  // run_numbers.cc
  const Op& number_steps();
  bool number_step(const Op& op);
  bool rare_number_step(const Op& op);
  bool mathematical_step(const Op& op);
  bool take(const Op& op, double value);
  bool take_truth(const Op& op, bool holds);
  [[nodiscard]] bool is_less(double a, double b) const;
  bool take_whole(const Op& op, Type type, AlarmId alarm);
  bool is_within_limits(const Op& op);
  bool array_step(const Op& op);
  bool failed(AlarmId id, std::string detail = {});
  bool failed(WrongValue wrong);
  bool index(const Op& op);
  Reference variable(std::int32_t which);
  [[nodiscard]] double loaded(const Reference& from, std::size_t element) const;
  bool store(const Reference& into, std::size_t element, double value);
  double& number(Operand place) {
    return banks_[static_cast<std::size_t>(place.bank)][place.place];
  }
  std::string& text(Operand place);
  Frame& frame(Operand place);

  // run_texts.cc
  bool text_step(const Op& op);
  bool frame_step(const Op& op);
  bool store_text(const Op& op);
  bool fill(const Op& op);
  bool repeat_value(const Op& op);
  bool set_element(const Reference& target, std::int32_t element, const Argument& value);
  Arguments arguments_of(const Op& op);

  // run_functions.cc: the column `work` of functions.def
  MaybeFailure call_function(const Op& op);
  [[nodiscard]] static std::string function_name(const Op& op);
  MaybeFailure bounded(const Op& op, Arguments list);
  MaybeFailure number_of_text(const Op& op, Arguments list);
  MaybeFailure shows_number(const Op& op, Arguments list);
  MaybeFailure length_of_text(const Op& op, Arguments list);
  MaybeFailure part_of_text(const Op& op, Arguments list);
  MaybeFailure upper_case(const Op& op, Arguments list);
  MaybeFailure lower_case(const Op& op, Arguments list);
  MaybeFailure formatted_text(const Op& op, Arguments list);
  MaybeFailure axis_of_name(const Op& op, Arguments list);
  MaybeFailure name_of_axis(const Op& op, Arguments list);
  MaybeFailure is_geometry_axis(const Op& op, Arguments list);
  MaybeFailure knows_variable(const Op& op, Arguments list);
  MaybeFailure knows_file(const Op& op, Arguments list);
  MaybeFailure modulo_place(const Op& op, Arguments list);
  [[nodiscard]] bool is_variable(std::string_view name);
  MaybeFailure take_place(const Op& op, std::size_t at);
  MaybeFailure needs_one_character(const Op& op, Arguments list);
  MaybeFailure first_place(const Op& op, Arguments list);
  MaybeFailure last_place(const Op& op, Arguments list);
  MaybeFailure first_of_set(const Op& op, Arguments list);
  MaybeFailure place_of_part(const Op& op, Arguments list);

  // run_frames.cc: those that make frames
  MaybeFailure shift_frame(const Op& op, Arguments list);
  MaybeFailure fine_shift_frame(const Op& op, Arguments list);
  MaybeFailure turn_frame(const Op& op, Arguments list);
  MaybeFailure solid_turn_frame(const Op& op, Arguments list);
  MaybeFailure scale_frame(const Op& op, Arguments list);
  MaybeFailure mirror_frame(const Op& op, Arguments list);
  MaybeFailure plane_turn_frame(const Op& op, Arguments list);
  MaybeFailure inverse_frame(const Op& op, Arguments list);
  MaybeFailure frame_of_components(const Op& op, Arguments list, Component component);
  struct AxisValue {
    int axis = 0;
    double value = 0.0;
  };
  Result<std::vector<AxisValue>, Failure> axis_values(const Op& op, Arguments list);

  // run_tools.cc
  MaybeFailure named_tool(const Op& op, Arguments list);
  MaybeFailure new_tool(const Op& op, Arguments list);
  MaybeFailure number_of_edge(const Op& op, Arguments list);
  MaybeFailure named_tool_in_use(const Op& op, Arguments list);
  double selected_tool(Arguments list);
  double tool_in_spindle(Arguments list);
  MaybeFailure delete_tool(Arguments list);
  MaybeFailure select_named_tool(Arguments list);
  double tool_named(Arguments list);

  // run_geometry.cc
  MaybeFailure circle_of_points(const Op& op, Arguments list);
  MaybeFailure measured_frame(const Op& op, Arguments list);

  // run_calls.cc
  MaybeFailure call(const Op& op);
  [[nodiscard]] CallablePrograms::Near near() const;
  Result<const CompiledProgram*, Failure> called(const CallSite& site);
  Result<const CompiledProgram*, Failure> written_program(std::string_view name);
  std::vector<BoundValue> bound(const CallSite& site);
  bool passes_over(const CallSite& site);
  MaybeFailure enter(const CompiledProgram& program, const std::vector<BoundValue>& values);
  std::vector<runtime::MissedTouches::Holder> holders_given(const CallSite& site,
                                                            const std::vector<BoundValue>& values);
  void follow_arguments(const std::vector<runtime::MissedTouches::Holder>& given);
  struct ReturnTarget {
    std::string label;  ///< or N and a number; empty: behind the call
    bool behind = false;
    std::size_t levels = 1;
  };
  Result<ReturnTarget, Failure> return_target(const Op& op);
  MaybeFailure return_from(const Op& op);
  MaybeFailure go_on_at(const ReturnTarget& target);
  MaybeFailure end_program(const Op& op);
  MaybeFailure end_text(const Op& op);
  void leave_level();
  MaybeFailure modal_call();
  void save_codes(Level& into);
  void restore_codes(const Level& from);

  // run_procedures.cc: the column `work` of procedures.def
  MaybeFailure procedure(const Op& op);
  MaybeFailure set_result(const Argument& target, double value);
  MaybeFailure message(Arguments list);
  MaybeFailure set_alarm(Arguments list);
  MaybeFailure execute_string(Arguments list);
  MaybeFailure set_master_spindle(Arguments list);
  MaybeFailure set_call_path(Arguments list);
  MaybeFailure stop_reading_ahead(Arguments list);
  MaybeFailure set_feed_axes(Arguments list);
  MaybeFailure couple_axis(Arguments list);
  MaybeFailure transformation_on(Arguments list);
  MaybeFailure transformation_off(Arguments list);
  MaybeFailure reset_orientation(Arguments list);
  MaybeFailure release_axis(Arguments list);

  // run_files.cc
  double write_file(Arguments list);
  double delete_file(Arguments list);
  void spend_on_reading(std::ptrdiff_t bytes);
  double read_file(Arguments list);
  double open_external(Arguments list);
  double write_external(Arguments list);
  double close_external(Arguments list);
  void append_line(const std::string& name, const std::string& line);
  void make_file(const std::string& name);
  bool remove_file(const std::string& name);
  /// Charges the budget of output.
  bool may_write(std::uint64_t bytes);

  // run_actions.cc
  struct ActionCode {
    const CompiledProgram* condition = nullptr;
    const CompiledProgram* actions = nullptr;
  };
  struct SynchronisedAction {
    ActionKind kind = ActionKind::Once;
    ActionScope scope = ActionScope::NextBlock;
    bool deletes_distance = false;
    const CompiledProgram* home = nullptr;  ///< whose variables it names
    std::size_t depth = 0;                  ///< of its level
    ActionCode code;
    source::Location where;
    bool held = false;        ///< its condition, when judged last; of FROM: ever
    bool is_through = false;  ///< WHEN that has acted
    bool is_locked = false;
  };
  MaybeFailure take_synchronised_action(const Op& op);
  MaybeFailure cancel_actions(Arguments list);
  MaybeFailure lock_actions(Arguments list);
  MaybeFailure unlock_actions(Arguments list);
  MaybeFailure disable_reading(Arguments list);
  MaybeFailure set_locked(Arguments list, bool locked);
  MaybeFailure act();
  MaybeFailure wait_to_read();
  MaybeFailure act_on(SynchronisedAction& action);
  [[nodiscard]] Result<std::size_t, Failure> level_of(const SynchronisedAction& action) const;
  MaybeFailure execute_with_actions(const Block& block);

  // run_words.cc
  MaybeFailure take_word(const Op& op);
  MaybeFailure take_text_word(const Op& op);
  MaybeFailure take_axis_word(const Op& op);
  MaybeFailure take_centre_of(int axis, const BlockWords::Word& word);
  MaybeFailure take_axis_setting(const BlockWords::AxisSetting& setting);
  MaybeFailure take_axis_measuring(const Op& op);
  MaybeFailure check_spindle(const Op& op);
  MaybeFailure take_skip_action(const Op& op);
  bool out_of_range(std::string_view name, double value, const ValueRange& range);
  bool set_word(std::size_t address, double value, Modification modification = Modification::None);
  MaybeFailure execute(const Op& op);

  // run_system.cc: the column `work` of system_variables.def
  MaybeFailure read_system(const Op& op);
  MaybeFailure write_system(const Op& op);
  Result<SystemAccess, Failure> system_access(const Op& op, Arguments indices);
  MaybeFailure show(const Op& op, const SystemAccess& access, const Result<double, Failure>& value);
  MaybeFailure show(const Op& op, const SystemAccess& access,
                    const Result<std::string, Failure>& value);
  MaybeFailure show(const Op& op, const SystemAccess& access, const Result<Frame, Failure>& value);
  MaybeFailure show(const Op& op, const SystemAccess& access, const Result<Frame*, Failure>& place);
  MaybeFailure set(const SystemAccess& access, const Argument& value,
                   MaybeFailure (*set_number)(Channel&, const SystemAccess&, double));
  MaybeFailure set(const SystemAccess& access, const Argument& value,
                   MaybeFailure (*set_text)(Channel&, const SystemAccess&, const std::string&));
  MaybeFailure set(const SystemAccess& access, const Argument& value,
                   Result<Frame*, Failure> (*find_frame)(Channel&, const SystemAccess&));
  Result<double, Failure> argument_given(const SystemAccess& access);
  Result<double, Failure> call_depth(const SystemAccess& access);
  Result<std::string, Failure> level_name(const SystemAccess& access);
  Result<std::string, Failure> level_folder(const SystemAccess& access);
  Result<std::string, Failure> level_path(const SystemAccess& access);
  Result<double, Failure> modal_call_active(const SystemAccess& access);

  CallablePrograms& programs_;
  /// What EXECSTRING compiled, by program and text.
  std::map<std::pair<const CompiledProgram*, std::string>, const CompiledProgram*> texts_run_;
  /// The same of files that the run wrote, by name and text.
  std::map<std::pair<std::string, std::string>, const CompiledProgram*> written_;
  std::size_t written_bytes_ = 0;  ///< of their texts
  Channel channel_;
  std::vector<std::unique_ptr<Level>> levels_;
  std::size_t depth_ = 0;
  double* banks_[4] = {};
  std::vector<double> number_temporaries_;
  std::vector<std::string> text_temporaries_;
  std::vector<Frame> frame_temporaries_;
  std::int32_t current_ = 0;  ///< the step being done
  MaybeFailure fault_;        ///< why the step failed that is being done
  BlockWords words_;
  struct ModalCall {
    const CompiledProgram* program = nullptr;
    std::vector<BoundValue> values;
    std::size_t depth = 0;  ///< of the level that said MCALL
  };
  std::optional<ModalCall> modal_call_;
  std::vector<SynchronisedAction> next_actions_;     ///< of the next block
  std::map<int, SynchronisedAction> modal_actions_;  ///< by ID
  /// What they compiled, by program, condition and actions.
  std::map<std::tuple<const CompiledProgram*, std::string, std::string>, ActionCode> action_texts_;
  bool is_acting_ = false;
  bool disables_reading_ = false;  ///< RDISABLE has acted when the actions were judged last
  /// What calls by name have found: programs stay, so it counts until CALLPATH.
  std::unordered_map<const CallSite*, const CompiledProgram*> found_calls_;
  std::set<const CallSite*> told_cycles_;  ///< that are not simulated
  /// What evaluate() compiled, by the program whose variables it names.
  std::map<std::pair<const CompiledProgram*, std::string>, const CompiledProgram*> expressions_;
  bool ended_ = false;      ///< the program
  bool is_paused_ = false;  ///< before the block that comes next
  bool is_over_ = false;    ///< the run; outcome_ says how
  runtime::Outcome outcome_;
  bool has_run_ = false;  ///< the main program
  std::optional<runtime::Outcome> early_failure_;
};

}  // namespace g31::sinumerik

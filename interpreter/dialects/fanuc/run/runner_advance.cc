#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/code/lathe.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/run/runner.h"
#include "interpreter/runtime/guarded.h"
#include "interpreter/runtime/stop_report.h"

namespace g31::fanuc {
namespace {

template <typename Work>
MaybeFailure guarded(const Work& work) {
  return runtime::guarded(work, budget_failure, defect_failure);
}

/// The signs of a main program, or what the control's own data say of the machine.
std::optional<LatheSigns> signs_of_a_lathe(const Control& control, const CompiledProgram& main) {
  constexpr int kX = 0;
  constexpr int kY = 1;
  const bool has_diameters = control.parameters.is_on_for_axis(ParameterId::DiameterAxis, kX);
  return has_diameters ? std::optional(LatheSigns{{}, "parameter 1006.3, DIA, of X"})
                       : lathe_signs(main, control.port.travel(kY).has_value());
}

}  // namespace

void Runner::begin(const runtime::Budget& budget, runtime::BlockListener* listener) {
  const CompiledProgram* const main = library_.main_program();
  if (main == nullptr) {
    outcome_.status = runtime::Status::SyntaxError;
    const source::SourceFile* const text = library_.main_text();
    outcome_.diagnostics.push_back(
        make_diagnostic(source::DiagnosticId::NoProgramInFile,
                        text != nullptr ? text->at({}) : source::Location()));
    is_over_ = true;
    return;
  }
  is_over_ = refuse_broken(*main);
  if (!is_over_) {
    start(*main);
    control_.watch = runtime::BlockWatch(budget, listener);
  }
}

/// Refuses a main program for a lathe, and one with a block that is reached and cannot be
/// understood.
bool Runner::refuse_broken(const CompiledProgram& main) {
  if (const auto signs = signs_of_a_lathe(control_, main)) {
    outcome_.status = runtime::Status::SyntaxError;
    outcome_.diagnostics.push_back(make_diagnostic(source::DiagnosticId::LatheProgram,
                                                   location_in(main, signs->where), signs->what));
    return true;
  }
  for (const syntax::SyntaxError& error : reachable_errors(main)) {
    const auto id = static_cast<AlarmId>(error.error);
    const AlarmInfo& row = info(id);
    runtime::StopReason reason;
    reason.status = runtime::Status::SyntaxError;
    reason.number = number_of(id, control_.profile.alarm_numbers);
    reason.text = row.text;
    reason.detail = error.message;
    reason.remedy = row.remedy;
    reason.levels = {{name_of(main), location_in(main, error.where)}};
    runtime::Outcome refused = runtime::outcome_of(std::move(reason));
    outcome_.status = refused.status;
    outcome_.alarm = outcome_.alarm ? outcome_.alarm : std::move(refused.alarm);
    outcome_.diagnostics.push_back(std::move(refused.diagnostics.back()));
  }
  return outcome_.status == runtime::Status::SyntaxError;
}

void Runner::start(const CompiledProgram& main) {
  stack_.start(main);
  control_.main_program = main.key.number;
  control_.modal.word('O') = main.key.number;
  if (!main.key.is_empty() && main.extent == Extent::Whole) {
    programs_.find(main.key);  // a second one of its number or name is told
  }
  control_.coordinates.arrived_at_machine(control_.port.position());
}

runtime::Advance Runner::advance() {
  if (is_over_) {
    return runtime::Advance::Ended;
  }
  is_paused_ = false;
  const MaybeFailure failure = guarded([this] { return loop(); });
  if (is_paused_) {
    return runtime::Advance::Paused;
  }
  end(failure);
  return runtime::Advance::Ended;
}

/// Waits until the axes stand.
/// @param reason  why the run ends before its program does, if it does
/// @returns the same, or what has shown in the motion that was still open
MaybeFailure Runner::come_to_rest(const MaybeFailure& reason) {
  if (reason && reason->broken_off) {
    return reason;
  }
  return guarded([&]() -> MaybeFailure {
    const auto late = control_.outlet.come_to_rest();
    return late ? from_late_fault(control_, *late) : reason;
  });
}

/// @param reason  why the run ends before its program does, if it does
void Runner::end(const MaybeFailure& reason) {
  is_over_ = true;
  is_paused_ = false;
  if (const MaybeFailure failure = come_to_rest(reason)) {
    if (runtime::breaks_off(failure->status)) {
      control_.report_unread_miss();
    }
    outcome_ = outcome_of(*failure);
  } else {
    control_.report_missed_touches();
  }
  library_.look_behind_main();
  programs_.take_reports();
  control_.tell_repeats();
  outcome_.diagnostics = control_.diagnostics;
  outcome_.blocks = control_.watch.blocks();
}

runtime::Outcome Runner::finish() {
  if (!is_over_) {
    end(halt_failure(runtime::BlockWatch::Halt::Stopped));
  }
  return outcome_;
}

std::vector<runtime::CallLevel> Runner::call_levels() const {
  return stack_.has_begun() ? levels_from(is_over_ ? stack_.here() : next_place().where)
                            : std::vector<runtime::CallLevel>();
}

std::vector<runtime::CallLevel> Runner::levels_from(source::Location innermost) const {
  std::vector<runtime::CallLevel> levels = stack_.levels();
  levels.front().where = innermost;
  return levels;
}

/// A late failure, or one of the machine, may be of a block at another level.
std::vector<runtime::CallLevel> Runner::levels_of(const Failure& failure) const {
  if (!failure.block.is_known()) {
    return levels_from(failure.place.is_known() ? failure.place : stack_.here());
  }
  const path::Outlet& outlet = control_.outlet;
  auto of_block = failure.status == runtime::Status::Collision ? outlet.fault_levels()
                                                               : outlet.levels_of(failure.calls);
  std::vector<runtime::CallLevel> levels =
      of_block ? *std::move(of_block) : levels_from(failure.block);
  levels.front().where = failure.block;
  return levels;
}

runtime::Outcome Runner::outcome_of(const Failure& failure) {
  const AlarmInfo& row = info(failure.id);
  runtime::StopReason reason;
  reason.status = failure.status;
  reason.number = failure.alarm_number != 0 ? failure.alarm_number
                                            : number_of(failure.id, control_.profile.alarm_numbers);
  reason.text = failure.alarm_text.empty() ? std::string(row.text) : failure.alarm_text;
  reason.detail = failure.detail;
  const bool may_loop =
      failure.alarm_number == static_cast<int>(source::DiagnosticId::BudgetBlocks) ||
      failure.alarm_number == static_cast<int>(source::DiagnosticId::BudgetTime);
  if (may_loop && reason.detail.empty() && control_.main_restarts > 1) {
    reason.detail =
        fmt::format(": M99 has begun the main program again {} times", control_.main_restarts);
  }
  reason.remedy = row.remedy;
  reason.levels = levels_of(failure);
  runtime::Outcome outcome = runtime::outcome_of(std::move(reason));
  control_.diagnostics.push_back(std::move(outcome.diagnostics.back()));
  outcome.diagnostics.clear();
  return outcome;
}

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/run/runner.h"

#include "interpreter/dialects/fanuc/run/evaluation_failure.h"
#include "interpreter/dialects/fanuc/run/printouts.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using syntax::BlockKind;
using syntax::kNone;

/// A failure of a block of `program`, where it stands: the block may have gone on to another one.
Failure placed_in(const CompiledProgram& program, Failure failure) {
  if (failure.where.end > failure.where.begin) {
    failure.place = location_in(program, failure.where);
  }
  return failure;
}

}  // namespace

Runner::Runner(const Profile& profile, ProgramLibrary& library, machine::MachinePort& port,
               runtime::Observer& observer)
    : library_(library),
      control_(profile, port, observer, system_),
      jumps_(stack_, library, control_),
      programs_(library, control_),
      assignments_(stack_, control_),
      blocks_(stack_, control_, programs_, jumps_) {
  system_.attach(control_);
  control_.here = [this] { return stack_.here(); };
  control_.outlet.show_by([this](const AxisPositions& q_M, const AxisPositions& q_M_commanded) {
    return runtime::ProgramView{control_.coordinates.tip_to_work(q_M),
                                control_.coordinates.tip_to_work(q_M_commanded), control_.tool,
                                runtime::calls_behind(stack_.levels())};
  });
  control_.outlet.show_levels_by([this] { return stack_.levels(); });
}

/// Statements that touch nothing but variables: the hot loop of a macro program.
/// @returns whether the step was one of them; the evaluator knows of a fault
[[gnu::hot]] bool Runner::fast_step(const Step& step, Frame& now) {
  Evaluator& evaluator = control_.evaluator;
  switch (step.kind) {
    case BlockKind::Empty:
    case BlockKind::Do:
      return true;
    case BlockKind::End:
      now.step = step.jump;
      return true;
    case BlockKind::Assign: {
      const bool is_common =
          step.target_kind == TargetKind::Common && !control_.variables.is_protected(step.number);
      if (!is_common && step.target_kind != TargetKind::Local) {
        return false;
      }
      const Cell value = evaluator.evaluate(*now.program, step.value);
      if (evaluator.failed()) [[unlikely]] {
        return true;
      }
      if (is_common) {
        control_.variables.set_common(step.number, value);
      } else {
        control_.variables.set_local(step.number, value);
      }
      return true;
    }
    case BlockKind::IfGoto:
      if (step.jump == kNone || step.enters_loop) {
        return false;
      }
      if (evaluator.condition(*now.program, step.condition)) {
        now.step = step.jump;
        has_jumped_ = true;
      }
      return true;
    case BlockKind::IfThen:
    case BlockKind::While:
      if (!evaluator.condition(*now.program, step.condition)) {
        now.step = step.jump;
      }
      return true;
    case BlockKind::Goto:
    case BlockKind::Nc:
    case BlockKind::Output:
    case BlockKind::SetNames:
    case BlockKind::Bad:
      return false;
  }
  return false;
}

[[gnu::hot]] MaybeFailure Runner::loop() {
  while (!stack_.has_ended()) {
    Frame& now = stack_.frame();
    if (now.step >= now.program->steps.size()) {
      if (auto failure = jumps_.behind_last_step()) {
        return failure;
      }
      continue;
    }
    const bool is_watched = !control_.watch.counts_at_once();
    const auto halt =
        is_watched ? control_.watch.next_block([this] { return next_place(); }) : std::nullopt;
    if (halt) {
      is_paused_ = *halt == runtime::BlockWatch::Halt::Paused;
      now.current = *halt == runtime::BlockWatch::Halt::Stopped ? now.step : now.current;
      return is_paused_ ? std::nullopt : MaybeFailure(halt_failure(*halt));
    }
    now.current = now.step;
    const CompiledProgram& program = *now.program;
    const Step& next = program.steps[now.step++];
    if (next.skip_switch != 0 && control_.block_skip.contains(next.skip_switch)) {
      continue;
    }
    const bool is_followed =
        control_.touches.missed.any() || (is_watched && control_.watch.write_listener() != nullptr);
    const BlockKind kind = next.kind;
    const bool is_plain = !is_followed || kind != BlockKind::Assign;
    has_jumped_ = false;
    if (is_plain && fast_step(next, now)) {
      if (control_.evaluator.failed()) [[unlikely]] {
        return placed_in(program, evaluation_failure(control_.evaluator));
      }
    } else if (auto failure = rare_step(next)) {
      return placed_in(program, *std::move(failure));
    }
    if (is_watched) [[unlikely]] {
      tell_condition(kind);
    }
  }
  return std::nullopt;
}

/// Tells a listener what became of the condition of the block that has run, if it has one.
void Runner::tell_condition(syntax::BlockKind kind) const {
  runtime::BlockListener* const listener = control_.watch.write_listener();
  const bool is_jump = kind == BlockKind::IfGoto;
  if (listener == nullptr || (!is_jump && kind != BlockKind::IfThen && kind != BlockKind::While)) {
    return;
  }
  const Frame& now = stack_.frame();
  // A GOTO may lead to the very next block.
  const bool is_met = is_jump ? has_jumped_ : now.step == now.current + 1;
  listener->on_condition(CallStack::location_of(now), is_met);
}

/// The block of the step that comes next.
runtime::BlockPlace Runner::next_place() const {
  const Frame& now = stack_.frame();
  const Step& step = now.program->steps[now.step];
  runtime::BlockPlace place;
  place.where = location_in(*now.program, now.program->tree->blocks[step.block].span);
  place.depth = static_cast<std::uint16_t>(stack_.depth());
  place.is_skipped = step.skip_switch != 0 && control_.block_skip.contains(step.skip_switch);
  return place;
}

[[gnu::hot]] MaybeFailure Runner::rare_step(const Step& step) {
  switch (step.kind) {
    case BlockKind::Nc:
      return blocks_.run(step);
    case BlockKind::Assign:
      return assignments_.assign(step);
    case BlockKind::Goto:
      return jumps_.jump(step);
    case BlockKind::IfGoto: {
      const bool holds = control_.evaluator.condition(*stack_.frame().program, step.condition);
      if (control_.evaluator.failed()) {
        return evaluation_failure(control_.evaluator);
      }
      has_jumped_ = holds;
      return holds ? jumps_.jump(step) : std::nullopt;
    }
    case BlockKind::Output:
      return print(control_, stack_, step);
    case BlockKind::Bad:
      return bad_block(step);
    case BlockKind::SetNames:
      return assignments_.set_names(step);
    case BlockKind::Empty:
    case BlockKind::Do:
    case BlockKind::End:
    case BlockKind::IfThen:
    case BlockKind::While:
      break;
  }
  contract_violated("fast_step does these", __FILE__, __LINE__);
}

MaybeFailure Runner::bad_block(const Step& step) {
  const syntax::SyntaxError& error =
      stack_.frame().program->errors[static_cast<std::size_t>(step.number)];
  Failure failure;
  failure.id = static_cast<AlarmId>(error.error);
  failure.where = error.where;
  failure.place = location_in(*stack_.frame().program, error.where);  // at the end of a text, too
  failure.detail = error.message;
  failure.status = runtime::Status::SyntaxError;
  return failure;
}

}  // namespace g31::fanuc

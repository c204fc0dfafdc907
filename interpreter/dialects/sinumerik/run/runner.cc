#include "interpreter/dialects/sinumerik/run/runner.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/state/call_arguments.h"
#include "interpreter/dialects/sinumerik/text/scanner.h"
#include "interpreter/runtime/stop_report.h"
#include "interpreter/source/latin_1.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {

Runner::Runner(CallablePrograms& programs, machine::MachinePort& port, runtime::Observer& observer)
    : programs_(programs),
      channel_(port, observer, programs.globals()),
      number_temporaries_(kTemporaryCount),
      text_temporaries_(kTemporaryCount),
      frame_temporaries_(kTemporaryCount) {
  levels_.push_back(std::make_unique<Level>());
  channel_.here = [this] { return here(); };
  channel_.outlet.show_by([this](const AxisPositions& q_M, const AxisPositions& q_M_commanded) {
    return runtime::ProgramView{channel_.to_work(q_M), channel_.to_work(q_M_commanded),
                                channel_.tool, calls_of(depth_)};
  });
}

void Runner::start(const CompiledProgram& program) {
  depth_ = 0;
  current_ = 0;
  ended_ = false;
  modal_call_.reset();
  next_actions_.clear();
  modal_actions_.clear();
  channel_.couplings.clear();
  words_.clear();
  *levels_.front() = Level();
  level().program = &program;
  level().make_locals();
  use_level();
}

/// What follows in a long program.  Windows have no local variables that could be lost.
MaybeFailure Runner::begin_window(const Op& /*op*/) {
  const ProgramWindows::Place place = programs_.next_window();
  level().program = place.program;
  level().step = place.step;
  return take_no_arguments();
}

/// What nobody calls has its preset values, and nothing to refer to.
MaybeFailure Runner::take_no_arguments() {
  MaybeFailure wrong = take_arguments(level(), {});
  use_level();
  return wrong;
}

void Runner::use_level() {
  // Constants are never written: no step has one as its result.
  banks_[0] = const_cast<double*>(level().program->constants.data());
  banks_[1] = level().numbers.data();
  banks_[2] = channel_.numbers.data();
  banks_[3] = number_temporaries_.data();
}

MaybeFailure Runner::loop() {
  while (!ended_ && !is_paused_) {
    if (channel_.touches.missed.any()) [[unlikely]] {
      if (MaybeFailure reason = any_step(take_step())) {
        return reason;
      }
      continue;
    }
    const Op& op = number_steps();
    if (fault_) {
      return from_step();
    }
    if (MaybeFailure reason = other_step(op)) {
      return reason;
    }
  }
  return std::nullopt;
}

/// Why a step failed, if it did.
MaybeFailure Runner::from_step() {
  MaybeFailure reason;
  reason.swap(fault_);
  return reason;
}

MaybeFailure Runner::other_step(const Op& op) {
  switch (op.code) {
#define NUMBER_STEP(name) case OpCode::name:
#define RARE_NUMBER_STEP(name) case OpCode::name:
#define JUMP_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    break;
#define ARRAY_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return array_step(op) ? std::nullopt : from_step();
#define TEXT_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return text_step(op) ? std::nullopt : from_step();
#define FRAME_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return frame_step(op) ? std::nullopt : from_step();
#define RUNNER_STEP(name, handler, reach) \
  case OpCode::name:                      \
    return handler(op);
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
  }
  contract_violated("number_steps() does steps on numbers and jumps", __FILE__, __LINE__);
}

/// What was wrong when the block was compiled.
MaybeFailure Runner::raise(const Op& op) {
  const BlockError& error = level().program->errors[static_cast<std::size_t>(op.a.place)];
  Failure wrong = failure(error.id, error.detail);
  if (info(error.id).of == AlarmOf::Text) {
    wrong.status = runtime::Status::SyntaxError;
  }
  return wrong;
}

MaybeFailure Runner::surplus_end(const Op& /*op*/) {
  channel_.warnings.add(channel_.diagnostics, source::DiagnosticId::SurplusEnd, here());
  return std::nullopt;
}

/// The block that the step `op` begins.
runtime::BlockPlace Runner::block_place(const Op& op) const {
  runtime::BlockPlace place;
  place.where = here();
  place.depth = static_cast<std::uint16_t>(depth_);
  place.is_shown = shown_level() == depth_;
  place.is_skipped = op.detail != 0 && skips(op.detail - 1);
  return place;
}

/// Whether a block is done: it is not when it is skipped, when it stands behind a part that REPEAT
/// runs, at a pause, and when the watch ends the run, which is a fault.
bool Runner::begins(const Op& op) {
  if (!level().parts.empty() && at_end_of_part(current_)) {
    return false;
  }
  if (const auto halt = channel_.watch.next_block([&] { return block_place(op); })) {
    is_paused_ = *halt == runtime::BlockWatch::Halt::Paused;
    if (is_paused_) {
      level().step = current_;
    } else {
      fault_ = halt_failure(*halt);
    }
    return false;
  }
  if (op.detail != 0 && skips(op.detail - 1)) {
    level().step = op.a.place;
    return false;
  }
  return true;
}

MaybeFailure Runner::block(const Op& op) {
  begins(op);
  return from_step();
}

MaybeFailure Runner::nc_block(const Op& op) {
  return begins(op) ? execute(op) : from_step();
}

/// `/` and `/0` are the first switch, whether a sheet counts it as 0 or 1.
bool Runner::skips(int which) const {
  return channel_.block_skip.contains(which) || (which == 0 && channel_.block_skip.contains(1));
}

/// A part of the program that REPEAT runs is through: once more, or on behind REPEAT.
bool Runner::at_end_of_part(std::int32_t step) {
  RunningPart& part = level().parts.back();
  const RepeatSite& site = level().program->repeats[static_cast<std::size_t>(part.site)];
  if (site.end != step) {
    return false;
  }
  if (--part.passes_left > 0) {
    level().step = site.first;
  } else {
    level().step = part.back_to;
    level().parts.pop_back();
  }
  return true;
}

MaybeFailure Runner::repeat_part(const Op& op) {
  Level& now = level();
  const bool is_running = !now.parts.empty() && now.parts.back().site == op.a.place;
  if (is_running && at_end_of_part(current_)) {
    return std::nullopt;
  }
  const RepeatSite& site = now.program->repeats[static_cast<std::size_t>(op.a.place)];
  if (site.first < 0) {
    return failure(AlarmId::SectionMissing);
  }
  const double passes = number(op.b);
  if (passes < 0.0 || passes > 9999.0) {
    return failure(AlarmId::BadRepeats, fmt::format("P{:.0f}", passes));
  }
  if (passes >= 1.0) {
    now.parts.push_back({op.a.place, now.step, static_cast<std::int32_t>(passes)});
    now.step = site.first;
  }
  return std::nullopt;
}

/// The level goes on at a step.  Control structures are interpreted as they come, so a control lets
/// a jump into one pass (programming manual, work preparation 02/2011, 1.12).
void Runner::arrive_at(std::int32_t step) {
  if (level().program->bodies.enters(current_, step)) {
    channel_.warnings.add(channel_.diagnostics, source::DiagnosticId::JumpIntoLoop, here());
  }
  level().step = step;
}

MaybeFailure Runner::jump_into(const Op& op) {
  arrive_at(op.a.place);
  return std::nullopt;
}

MaybeFailure Runner::jump_to_text(const Op& op) {
  const std::string name = upper(text(op.a));
  const auto direction = static_cast<Direction>(op.detail);
  const auto target = find_label(*level().program, name, current_, direction);
  if (target) {
    arrive_at(*target);
  } else if (direction != Direction::BothQuiet) {
    return failure(AlarmId::JumpTargetMissing, name);
  }
  return std::nullopt;
}

/// Where a level waits for the program that it called.
source::Location Runner::place_of_call(std::size_t which) const {
  const Level& level = *levels_[which];
  const auto step = static_cast<std::size_t>(std::max(level.step - 1, 0));
  return location_in(*level.program, level.program->spans[step]);
}

/// The level whose block an alarm shows.  DISPLOF hides the blocks of its program behind the call;
/// ACTBLOCNO shows the block itself, of programs with DISPLOF that it calls, too.
std::size_t Runner::shown_level() const {
  std::size_t which = depth_;
  for (; which > 0 && levels_[which]->program->hides_blocks; --which) {
    if (levels_[which]->program->shows_actual_block) {
      return depth_;
    }
  }
  return which;
}

source::Location Runner::here() const {
  const CompiledProgram& program = *levels_[depth_]->program;
  return location_in(program, program.spans[static_cast<std::size_t>(current_)]);
}

/// The calls that have led to a level, the innermost first.
std::vector<runtime::CallSite> Runner::calls_of(std::size_t which) const {
  std::vector<runtime::CallSite> calls;
  for (std::size_t i = which; i > 0; --i) {
    calls.push_back({levels_[i - 1]->program->name, place_of_call(i - 1)});
  }
  return calls;
}

runtime::Outcome Runner::outcome_of(const Failure& failure) {
  const AlarmInfo& row = info(failure.id);
  runtime::StopReason reason;
  reason.status = failure.status;
  reason.is_alarm = failure.is_alarm;
  reason.number = failure.number != 0 ? failure.number : row.number;
  reason.text = failure.text.empty() ? std::string(row.text) : source::as_utf8(failure.text);
  reason.detail = failure.detail;
  reason.remedy = row.remedy;
  const auto place_in = [&](std::size_t which) {
    return which == depth_ ? failure.where.value_or(here()) : place_of_call(which);
  };
  const std::size_t shown = shown_level();
  reason.where = place_in(shown);
  for (std::size_t i = depth_; i > shown; --i) {
    reason.inside.push_back({levels_[i]->program->name, place_in(i)});
  }
  reason.calls = calls_of(shown);
  runtime::Outcome outcome = runtime::outcome_of(std::move(reason));
  channel_.diagnostics.push_back(std::move(outcome.diagnostics.back()));
  outcome.diagnostics.clear();
  return outcome;
}

}  // namespace g31::sinumerik

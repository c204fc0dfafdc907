#include "interpreter/dialects/fanuc/run/runner.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using syntax::BlockKind;
using syntax::kNone;

}  // namespace

Runner::Runner(const Profile& profile, ProgramLibrary& library, machine::MachinePort& port,
               runtime::Observer& observer)
    : library_(library), control_(profile, port, observer, system_) {
  system_.attach(control_);
  control_.here = [this] { return location_of(frame()); };
  control_.outlet.show_by([this](const AxisPositions& q_M, const AxisPositions& q_M_commanded) {
    return runtime::ProgramView{control_.coordinates.tip_to_work(q_M),
                                control_.coordinates.tip_to_work(q_M_commanded), control_.tool,
                                call_stack()};
  });
}

/// Statements that touch nothing but variables: the hot loop of a macro program.
/// @returns whether the step was one of them; the evaluator knows of a fault
bool Runner::fast_step(const Step& step, Frame& now) {
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

MaybeFailure Runner::loop() {
  while (!ended_) {
    Frame& now = frames_.back();
    if (now.step >= now.program->steps.size()) {
      if (auto failure = behind_last_step()) {
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
    const Step& next = now.program->steps[now.step++];
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
        return from_evaluation();
      }
    } else if (auto failure = rare_step(next)) {
      return failure;
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
  const Frame& now = frames_.back();
  // A GOTO may lead to the very next block.
  const bool is_met = is_jump ? has_jumped_ : now.step == now.current + 1;
  listener->on_condition(location_of(now), is_met);
}

/// The block of the step that comes next.
runtime::BlockPlace Runner::next_place() const {
  const Frame& now = frames_.back();
  const Step& step = now.program->steps[now.step];
  runtime::BlockPlace place;
  place.where = location_in(*now.program, now.program->tree->blocks[step.block].span);
  place.depth = static_cast<std::uint16_t>(frames_.size() - 1);
  place.is_skipped = step.skip_switch != 0 && control_.block_skip.contains(step.skip_switch);
  return place;
}

/// Goes on in the next window of a long program, or says that the program has no end.
MaybeFailure Runner::behind_last_step() {
  const CompiledProgram& program = *frame().program;
  if (const auto next = library_.behind(program)) {
    frame().program = next->program;
    frame().step = next->step;
    return std::nullopt;
  }
  Failure failure;
  failure.id = AlarmId::EndOfRecord;
  failure.detail = fmt::format("{} ends without M30, M02 or M99", name_of(program));
  return failure;
}

MaybeFailure Runner::rare_step(const Step& step) {
  switch (step.kind) {
    case BlockKind::Nc:
      return nc_block(step);
    case BlockKind::Assign:
      return assign(step);
    case BlockKind::Goto:
      return jump(step);
    case BlockKind::IfGoto: {
      const bool holds = control_.evaluator.condition(*frame().program, step.condition);
      if (control_.evaluator.failed()) {
        return from_evaluation();
      }
      has_jumped_ = holds;
      return holds ? jump(step) : std::nullopt;
    }
    case BlockKind::Output:
      return output(step);
    case BlockKind::Bad:
      return bad_block(step);
    case BlockKind::SetNames:
      return set_names(step);
    case BlockKind::Empty:
    case BlockKind::Do:
    case BlockKind::End:
    case BlockKind::IfThen:
    case BlockKind::While:
      break;
  }
  contract_violated("fast_step does these", __FILE__, __LINE__);
}

/// SETVN: on controls without names in programs they only show on the screen (MB-104).
MaybeFailure Runner::set_names(const Step& step) {
  const CompiledProgram& program = *frame().program;
  const syntax::ShortSpan span = program.tree->blocks[step.block].text;
  std::int32_t number = step.number;
  const std::string_view list = program.file->text().substr(span.begin, span.end - span.begin);
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    std::string name = upper_case(list.substr(begin, comma - begin));
    begin = comma + 1;
    std::erase_if(name, [](char c) { return c == ' ' || c == '\t'; });
    const NameRule& rule = control_.profile.names;
    const bool in_range = is_common(number) && number >= rule.first && number <= rule.last;
    if (!in_range || static_cast<int>(name.size()) > rule.longest) {
      Failure failure;
      failure.id = in_range ? AlarmId::NameFormat : AlarmId::IllegalVariable;
      failure.detail =
          in_range ? fmt::format("a name has at most {} characters", rule.longest)
                   : fmt::format("SETVN names #{} to #{}, not #{}", rule.first, rule.last, number);
      return failure;
    }
    control_.variables.names.give(std::move(name), number++);
  }
  return std::nullopt;
}

MaybeFailure Runner::bad_block(const Step& step) {
  const syntax::SyntaxError& error = frame().program->errors[static_cast<std::size_t>(step.number)];
  Failure failure;
  failure.id = static_cast<AlarmId>(error.error);
  failure.where = error.where;
  failure.detail = error.message;
  failure.status = runtime::Status::SyntaxError;
  return failure;
}

MaybeFailure Runner::jump(const Step& step) {
  if (step.jump != kNone) {
    if (step.enters_loop) {
      return arrive_at(frame(), step.jump);
    }
    frame().step = step.jump;
    return std::nullopt;
  }
  const CompiledProgram& program = *frame().program;
  const Cell target = control_.evaluator.value(program, step.value);
  control_.touches.missed.compares();
  if (control_.evaluator.failed()) {
    return from_evaluation();
  }
  const double rounded = std::round(target.or_zero());
  Failure failure;
  failure.where = program.op_spans[step.value];
  if (rounded < 1.0 || rounded > control_.profile.largest_sequence) {
    failure.id = AlarmId::IllegalJump;
    failure.detail = fmt::format("GOTO {}", rounded);
    return failure;
  }
  failure.id = AlarmId::JumpNotFound;
  failure.detail = fmt::format("{} has no N{}", name_of(program), rounded);
  return go_to(frame(), nearest_integer(rounded), std::move(failure));
}

/// The frame goes on at a step; a control lets a jump into a loop pass.
MaybeFailure Runner::arrive_at(Frame& frame, syntax::Index step) {
  if (frame.program->enters_loop(frame.current, step)) {
    control_.warn(source::DiagnosticId::JumpIntoLoop, control_.here());
  }
  frame.step = step;
  return std::nullopt;
}

/// A jump is ahead: the whole program must be known.
MaybeFailure Runner::keep_whole(Frame& frame) {
  const auto here = library_.in_whole({frame.program, frame.current});
  if (!here) {
    Failure failure;
    failure.id = AlarmId::SequenceNotFound;
    failure.detail = "a program file with jumps must be shorter than 4 GiB";
    return failure;
  }
  frame.program = here->program;
  frame.step += here->step - frame.current;
  frame.current = here->step;
  return std::nullopt;
}

/// The frame goes on at N `sequence`; `missing` is what it means when there is no such block.
MaybeFailure Runner::go_to(Frame& frame, int sequence, Failure missing) {
  if (auto failure = keep_whole(frame)) {
    return failure;
  }
  const auto found = frame.program->find_label(sequence, frame.current);
  if (!found) {
    return missing;
  }
  return arrive_at(frame, *found);
}

MaybeFailure Runner::assign(const Step& step) {
  const CompiledProgram& program = *frame().program;
  std::int32_t number = step.number;
  if (step.target_kind == TargetKind::Computed) {
    const Cell index = control_.evaluator.evaluate(program, step.target);
    if (control_.evaluator.failed()) {
      return from_evaluation();
    }
    number = variable_number(index.or_zero());
  }
  const Cell value = control_.evaluator.value(program, step.value);
  if (control_.evaluator.failed()) {
    return from_evaluation();
  }
  const bool is_heard = control_.watch.write_listener() != nullptr;
  const Cell before = is_heard ? looked_at(number).value_or(Cell()) : Cell();
  if (const auto refused = control_.all_variables.write(number, value)) {
    Failure failure;
    failure.id = *refused;
    failure.where = program.tree->blocks[step.block].span;
    failure.detail = fmt::format("#{} cannot be written", number);
    return failure;
  }
  if (is_heard) {
    tell_write(number, before, value);
  }
  if (control_.touches.missed.any()) {
    control_.touches.missed.assigns(holder_of(control_.variables.depth(), number));
  }
  return assigned_system_variable(number, value.or_zero());
}

/// What a variable shows when nobody asks for it.
std::optional<Cell> Runner::looked_at(std::int32_t number) {
  const runtime::LookFromOutside look(control_.touches);
  const auto value = control_.all_variables.read(number);
  return value ? std::optional(value.value()) : std::nullopt;
}

void Runner::tell_write(std::int32_t number, Cell before, Cell written) {
  control_.watch.write_listener()->on_write({fmt::format("#{}", number), before,
                                             looked_at(number).value_or(written),
                                             location_of(frame())});
}

/// What an assignment to #3000 or #3006 sets off, with the comment behind it as text.
MaybeFailure Runner::assigned_system_variable(int number, double value) {
  if (number != 3000 && number != 3006) {
    return std::nullopt;
  }
  const CompiledProgram& program = *frame().program;
  const syntax::Block& block = program.tree->blocks[program.steps[frame().current].block];
  const std::string text(
      program.file->text().substr(block.text.begin, block.text.end - block.text.begin));
  if (auto failure = end_read_ahead(control_)) {
    return failure;
  }
  if (number == 3006) {
    control_.observer.on_stop({"#3006", text, location(block.span)});
    return std::nullopt;
  }
  Failure failure;
  failure.id = AlarmId::MacroAlarm;
  failure.where = block.span;
  failure.alarm_text = text.empty() ? std::string(info(AlarmId::MacroAlarm).text) : text;
  const MacroAlarmRule& rule = control_.profile.macro_alarm;
  const int n = nearest_integer(value);
  const bool plain =
      rule.has_plain_numbers && control_.parameters.is_on(ParameterId::PlainAlarmNumber);
  const bool adds = rule.number == MacroAlarmRule::Number::BasePlusValue;
  failure.alarm_number = plain ? n : rule.base + (adds ? n : 0);
  if (n < rule.smallest || n > rule.largest) {
    failure.detail = fmt::format("#3000 takes {} to {}", rule.smallest, rule.largest);
  } else if (!adds) {
    failure.detail = std::to_string(n);
  }
  return failure;
}

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/run/jumps.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/run/evaluation_failure.h"

namespace g31::fanuc {
namespace {

using syntax::kNone;

}  // namespace

MaybeFailure Jumps::jump(const Step& step) {
  if (step.jump != kNone) {
    if (step.enters_loop) {
      return arrive_at(frame(), step.jump);
    }
    frame().step = step.jump;
    return std::nullopt;
  }
  const CompiledProgram& program = *frame().program;
  const Cell target = control_.evaluator.value(program, step.value);
  control_.touches.missed.decides();
  if (control_.evaluator.failed()) {
    return evaluation_failure(control_.evaluator);
  }
  const double rounded = std::round(target.or_zero());
  Failure failure;
  failure.where = program.op_spans[step.value];
  if (rounded < control_.profile.smallest_target || rounded > control_.profile.largest_sequence) {
    failure.id = AlarmId::IllegalJump;
    failure.detail = fmt::format("GOTO {}", rounded);
    return failure;
  }
  failure.id = AlarmId::JumpNotFound;
  failure.detail = fmt::format("{} has no N{}", name_of(program), rounded);
  return go_to(frame(), nearest_integer(rounded), std::move(failure));
}

/// A level goes on at a step; a control lets a jump into a loop pass.
MaybeFailure Jumps::arrive_at(Frame& level, syntax::Index step) {
  if (level.program->enters_loop(level.current, step)) {
    control_.warn(source::DiagnosticId::JumpIntoLoop, control_.here());
  }
  level.step = step;
  return std::nullopt;
}

MaybeFailure Jumps::keep_whole(Frame& level) {
  const auto here = library_.in_whole({level.program, level.current});
  if (!here) {
    Failure failure;
    failure.id = AlarmId::SequenceNotFound;
    failure.detail = "a program file with jumps must be shorter than 4 GiB";
    return failure;
  }
  level.program = here->program;
  level.step += here->step - level.current;
  level.current = here->step;
  return std::nullopt;
}

MaybeFailure Jumps::go_to(Frame& level, int sequence, Failure missing) {
  if (auto failure = keep_whole(level)) {
    return failure;
  }
  const auto found = level.program->find_label(sequence, level.current);
  if (!found) {
    return missing;
  }
  return arrive_at(level, *found);
}

MaybeFailure Jumps::behind_last_step() {
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

}  // namespace g31::fanuc

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
      return arrive_at(step.jump);
    }
    frame().step = step.jump;
    return std::nullopt;
  }
  const CompiledProgram& program = *frame().program;
  const Cell target = control_.evaluator.value(program, step.value);
  control_.touches.missed.compares();
  if (control_.evaluator.failed()) {
    return evaluation_failure(control_.evaluator);
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
  return go_to(nearest_integer(rounded), std::move(failure));
}

/// The program goes on at a step; a control lets a jump into a loop pass.
MaybeFailure Jumps::arrive_at(syntax::Index step) {
  if (frame().program->enters_loop(frame().current, step)) {
    control_.warn(source::DiagnosticId::JumpIntoLoop, control_.here());
  }
  frame().step = step;
  return std::nullopt;
}

MaybeFailure Jumps::keep_whole() {
  Frame& now = frame();
  const auto here = library_.in_whole({now.program, now.current});
  if (!here) {
    Failure failure;
    failure.id = AlarmId::SequenceNotFound;
    failure.detail = "a program file with jumps must be shorter than 4 GiB";
    return failure;
  }
  now.program = here->program;
  now.step += here->step - now.current;
  now.current = here->step;
  return std::nullopt;
}

MaybeFailure Jumps::go_to(int sequence, Failure missing) {
  if (auto failure = keep_whole()) {
    return failure;
  }
  const auto found = frame().program->find_label(sequence, frame().current);
  if (!found) {
    return missing;
  }
  return arrive_at(*found);
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

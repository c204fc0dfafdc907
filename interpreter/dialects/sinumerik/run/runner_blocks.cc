// Blocks, jumps and parts to repeat.

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/run/runner.h"

namespace g31::sinumerik {

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
  channel_.warnings.add(channel_.diagnostics, source::DiagnosticId::SurplusEnd, stack_.here());
  return std::nullopt;
}

MaybeFailure Runner::watch_datum(const Op& op) {
  const Variable& datum = level().program->variables[static_cast<std::size_t>(op.b.place)];
  const double value = operands_.number(op.a);
  if (datum.is_watched) {
    const auto first = static_cast<std::size_t>(datum.place);
    const auto count = static_cast<std::size_t>(datum.shape.count());
    const auto element = static_cast<std::size_t>(std::max(operands_.number(op.result), 0.0));
    for (std::size_t i = 0; i < count; ++i) {
      if (op.detail != 0 || i == element) {
        channel_.motion_data.written(first + i);
      }
    }
  }
  if (datum.fixed && value != datum.fixed) {
    channel_.warnings.add(channel_.diagnostics, source::DiagnosticId::DatumWithoutEffect,
                          stack_.here(),
                          fmt::format("{} = {}: the run goes on as with {}", datum.name, value,
                                      datum.fixed.value_or(0.0)));
  }
  return std::nullopt;
}

MaybeFailure Runner::tell_not_simulated(const Op& op) {
  channel_.warnings.add(channel_.diagnostics, source::DiagnosticId::NotSimulated, stack_.here(),
                        operands_.text(op.a));
  return std::nullopt;
}

/// The block that the step `op` begins.
runtime::BlockPlace Runner::block_place(const Op& op) const {
  runtime::BlockPlace place;
  place.where = stack_.here();
  place.depth = static_cast<std::uint16_t>(stack_.depth());
  place.is_shown = stack_.shown_level() == stack_.depth();
  place.is_skipped = op.detail != 0 && skips(op.detail - 1);
  return place;
}

/// Whether a block is done: it is not when it is skipped, when it stands behind a part that REPEAT
/// runs, at a pause, and when the watch ends the run, which is a fault.
bool Runner::begins(const Op& op) {
  if (!level().parts.empty() && at_end_of_part(stack_.current())) {
    return false;
  }
  if (const auto halt = channel_.watch.next_block([&] { return block_place(op); })) {
    is_paused_ = *halt == runtime::BlockWatch::Halt::Paused;
    if (is_paused_) {
      level().step = stack_.current();
    } else {
      machine_.fault().keep(halt_failure(*halt));
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
  return machine_.fault().taken();
}

MaybeFailure Runner::nc_block(const Op& op) {
  return begins(op) ? execute(op) : machine_.fault().taken();
}

/// `/` and `/0` are the first switch, whether a sheet counts it as 0 or 1.
bool Runner::skips(int which) const {
  return channel_.block_skip.contains(which) || (which == 0 && channel_.block_skip.contains(1));
}

/// A part of the program that REPEAT runs is through: once more, or on behind REPEAT.
bool Runner::at_end_of_part(std::int32_t step) {
  RunningPart& part = level().parts.back();
  if (part.end != step) {
    return false;
  }
  if (part.site == RunningPart::kWholeLevel) {
    if (MaybeFailure wrong = calls_.return_from(Op())) {
      machine_.fault().keep(std::move(*wrong));
    }
  } else if (--part.passes_left > 0) {
    level().step = level().program->repeats[static_cast<std::size_t>(part.site)].first;
  } else {
    level().step = part.back_to;
    level().parts.pop_back();
  }
  return true;
}

MaybeFailure Runner::repeat_part(const Op& op) {
  Level& now = level();
  const bool is_running = !now.parts.empty() && now.parts.back().site == op.a.place;
  if (is_running && at_end_of_part(stack_.current())) {
    return std::nullopt;
  }
  const RepeatSite& site = now.program->repeats[static_cast<std::size_t>(op.a.place)];
  if (site.first < 0) {
    return failure(AlarmId::SectionMissing, site.missing);
  }
  const double passes = operands_.number(op.b);
  if (MaybeFailure wrong = failure(wrong_passes(passes))) {
    return wrong;
  }
  if (passes >= 1.0) {
    now.parts.push_back({op.a.place, site.end, now.step, static_cast<std::int32_t>(passes)});
    now.step = site.first;
  }
  return std::nullopt;
}

/// CALL BLOCK with texts as labels: where they are is known now only.
MaybeFailure Runner::repeat_text(const Op& op) {
  Level& now = level();
  const std::int32_t here = stack_.current();
  const bool is_through = !now.parts.empty() && now.parts.back().site == RunningPart::kByText &&
                          now.parts.back().end == here;
  if (is_through && at_end_of_part(here)) {
    return std::nullopt;
  }
  const std::string first = upper(operands_.text(op.a));
  const std::string last = upper(operands_.text(op.b));
  const auto part = find_part(*now.program, first, last, here);
  if (!part) {
    return failure(AlarmId::SectionMissing, fmt::format("{} to {}", first, last));
  }
  // As REPEAT: what begins in front of its call ends there at the latest.
  const std::int32_t end = part->first < here ? std::min(part->end, here) : part->end;
  now.parts.push_back({RunningPart::kByText, end, now.step, 1});
  now.step = part->first;
  return std::nullopt;
}

/// The level goes on at a step.  Control structures are interpreted as they come, so a control lets
/// a jump into one pass (programming manual, work preparation 02/2011, 1.12).
void Runner::arrive_at(std::int32_t step) {
  if (level().program->bodies.enters(stack_.current(), step)) {
    channel_.warnings.add(channel_.diagnostics, source::DiagnosticId::JumpIntoLoop, stack_.here());
  }
  level().step = step;
}

MaybeFailure Runner::jump_into(const Op& op) {
  arrive_at(op.a.place);
  return std::nullopt;
}

MaybeFailure Runner::jump_to_text(const Op& op) {
  const std::string name = upper(operands_.text(op.a));
  const auto direction = static_cast<Direction>(op.detail);
  const auto target = find_label(*level().program, name, stack_.current(), direction);
  if (target) {
    arrive_at(*target);
  } else if (direction != Direction::BothQuiet) {
    return failure(AlarmId::JumpTargetMissing, name);
  }
  return std::nullopt;
}

/// M2, M30 and the last block: of a called program they are its end only.
MaybeFailure Runner::end_program(const Op& /*op*/) {
  if (!level().parts.empty() && at_end_of_part(stack_.current())) {
    return std::nullopt;
  }
  return calls_.return_from(Op());
}

MaybeFailure Runner::execute(const Op& op) {
  const CompiledProgram& program = *level().program;
  const NcBlock& block = program.nc_blocks[static_cast<std::size_t>(op.b.place)];
  if (MaybeFailure wrong = words_.take_constants(block.words_of(program))) {
    return wrong;
  }
  BlockWords& words = words_.words();
  std::vector<std::uint16_t> with_computed;
  std::span<const std::uint16_t> codes = block.codes_of(program);
  if (!words.computed_codes.empty()) {
    with_computed.assign(codes.begin(), codes.end());
    with_computed.insert(with_computed.end(), words.computed_codes.begin(),
                         words.computed_codes.end());
    codes = with_computed;
  }
  const Block commands(words, codes, stack_.here());
  const bool moves = stack_.modal_call && commands_motion(commands);
  MaybeFailure wrong = actions_.execute(commands);
  words.clear();
  if (!wrong && moves && !channel_.held_line) {
    return calls_.modal_call();
  }
  return wrong;
}

}  // namespace g31::sinumerik

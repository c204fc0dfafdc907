#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

/// The G codes of a block, sorted by what they do.
struct Codes {
  const GCode* one_shot = nullptr;
  const GCode* tool_length = nullptr;
  const GCode* work_offset = nullptr;
};

MaybeFailure take_g_word(Control& control, const EvaluatedWord& word, Codes& codes) {
  const auto number = g_number(word.number);
  const GCode* const code = number ? find_g_code(*number) : nullptr;
  if (code == nullptr || std::ranges::count(control.profile.missing_g_codes, *number) != 0) {
    return at_word(AlarmId::ImproperGCode, word,
                   fmt::format("the control has no G{}", word.number));
  }
  if (code->group == 0) {
    codes.one_shot = code;
    return std::nullopt;
  }
  if (code->action == GAction::ToolLength) {
    codes.tool_length = code;
  } else if (code->action == GAction::WorkOffset) {
    codes.work_offset = code;
  }
  control.modal.group[static_cast<std::size_t>(code->group)] = code->number;
  return std::nullopt;
}

/// F S T M and the like: recorded for #4102.., M codes otherwise skipped.
MaybeFailure take_plain_word(Control& control, const EvaluatedWord& word) {
  switch (word.letter) {
    case 'F':
      if (word.number < 0.0) {
        return at_word(AlarmId::IllegalMinus, word, "a feed is not negative");
      }
      control.modal.feed = word.number;
      return std::nullopt;
    case 'M':
    case 'S':
    case 'T':
    case 'D':
    case 'H': {
      const auto number = integer_of(word);
      if (!number) {
        return number.error();
      }
      control.modal.word(word.letter) = number.value();
      return std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

MaybeFailure execute_action(Control& control, const NcBlock& block) {
  switch (block.one_shot->action) {
    case GAction::Dwell:
      return execute_dwell(control, block);
    case GAction::SetData:
      return execute_set_data(control, block);
    case GAction::ToReference:
      return execute_reference(control, block);
    case GAction::Skip:
      return execute_skip(control, block);
    case GAction::MeasureTool:
      return execute_tool_measurement(control, block);
    case GAction::LocalShift:
      return execute_local_shift(control, block);
    case GAction::MachineMove:
      return execute_machine_move(control, block);
    case GAction::SetPosition:
      return execute_set_position(control, block);
    case GAction::Modal:
    case GAction::Motion:
    case GAction::ToolLength:
    case GAction::WorkOffset:
    case GAction::MacroCall:
      break;
  }
  contract_violated("one-shot codes have an action; calls never come here", __FILE__, __LINE__);
}

bool has_axis_word(const BlockWords& words) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (words.has(kAxisLetters[axis])) {
      return true;
    }
  }
  return false;
}

/// What the words command when the modal codes and offsets are in force.
MaybeFailure execute_words(Control& control, const NcBlock& block, double feed_before) {
  if (block.one_shot == nullptr) {
    return block.has_axis_word ? execute_motion(control, block) : std::nullopt;
  }
  auto failure = execute_action(control, block);
  if (block.one_shot->action == GAction::Skip && control.profile.skip_feed == SkipFeed::OneBlock) {
    control.modal.feed = feed_before;
  }
  return failure;
}

}  // namespace

MaybeFailure execute_block(Control& control, const BlockWords& words, source::Location where) {
  Codes codes;
  const double feed_before = control.modal.feed;
  for (const EvaluatedWord& word : words.all()) {
    MaybeFailure failure =
        word.letter == 'G' ? take_g_word(control, word, codes) : take_plain_word(control, word);
    if (failure) {
      return failure;
    }
  }
  const auto unit = control.modal.group[6].whole == 20 ? LengthUnit::Inch : LengthUnit::Millimetre;
  if (unit != control.scale.unit) {
    control.set_unit(unit);
  }
  if (codes.work_offset != nullptr) {
    if (auto failure = select_work_offset(control, words, codes.work_offset->number)) {
      return failure;
    }
  }
  const bool length_in_force = control.modal.group[8].whole != 49;
  if (codes.tool_length != nullptr || (length_in_force && words.has('H'))) {
    if (auto failure = select_tool_length(control, words)) {
      return failure;
    }
  }
  const NcBlock block{words, where, codes.one_shot, has_axis_word(words)};
  if (auto failure = read_compensation(control, block)) {
    return failure;
  }
  if (auto failure = execute_words(control, block, feed_before)) {
    return failure;
  }
  return end_compensated_block(control);
}

Failure at_word(AlarmId id, const EvaluatedWord& word, std::string detail) {
  Failure failure;
  failure.id = id;
  failure.where = word.span;
  failure.detail = std::move(detail);
  return failure;
}

Result<int, Failure> integer_of(const EvaluatedWord& word) {
  if (word.form == syntax::ValueForm::Decimal) {
    return at_word(AlarmId::IllegalPoint, word, fmt::format("{} takes an integer", word.letter));
  }
  return nearest_integer(word.number);
}

Failure from_fault(const machine::MachineFault& fault) {
  Failure failure;
  failure.status = runtime::Status::Collision;
  failure.id = AlarmId::SoftLimit;
  failure.alarm_number = fault.kind == machine::FaultKind::SoftLimit ? 0 : -1;
  failure.detail = fault.what;
  return failure;
}

}  // namespace g31::fanuc

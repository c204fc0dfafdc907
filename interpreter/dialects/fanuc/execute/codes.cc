#include "interpreter/dialects/fanuc/execute/codes.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

void end_canned_cycle(Control& control) {
  control.modal.group[9] = {80, 0};
}

/// What a modal code does at once, before the other words of its block.
void take_modal_code(Control& control, const GCode& code, Codes& codes) {
  switch (code.action) {
    case GAction::ToolLength:
      codes.tool_length = &code;
      break;
    case GAction::WorkOffset:
      codes.work_offset = &code;
      break;
    case GAction::Mirror:
    case GAction::MirrorOff:
    case GAction::Scaling:
    case GAction::Rotation:
    case GAction::StrokeCheck:
      codes.frame = &code;
      break;
    case GAction::ScalingOff:
      cancel_scaling(control);
      break;
    case GAction::RotationOff:
      cancel_rotation(control);
      break;
    case GAction::PolarOn:
      codes.starts_polar = true;
      break;
    case GAction::PolarOff:
      control.polar.reset();
      codes.starts_polar = false;
      break;
    case GAction::Motion:
    case GAction::CycleOff:
      end_canned_cycle(control);
      break;
    case GAction::CannedCycle:
      codes.starts_cycle = codes.starts_cycle || !in_canned_cycle(control);
      break;
    case GAction::SurfaceSpeed:
      codes.unsimulated = &code;
      break;
    case GAction::Modal:
    case GAction::NoEffect:
    case GAction::ExactStop:
    case GAction::Dwell:
    case GAction::SetData:
    case GAction::EndData:
    case GAction::CheckReference:
    case GAction::ToReference:
    case GAction::FromReference:
    case GAction::Skip:
    case GAction::MeasureTool:
    case GAction::LocalShift:
    case GAction::MachineMove:
    case GAction::MacroCall:
    case GAction::SetPosition:
    case GAction::PresetSystem:
      break;
  }
  control.modal.group[static_cast<std::size_t>(code.group)] = code.number;
}

MaybeFailure take_g_word(Control& control, const EvaluatedWord& word, Codes& codes) {
  const auto number = g_number(word.number);
  const GCode* const code = number ? find_g_code(*number) : nullptr;
  if (code == nullptr || std::ranges::count(control.profile.missing_g_codes, *number) != 0) {
    return at_word(AlarmId::ImproperGCode, word,
                   fmt::format("the control has no G{}", word.number));
  }
  if (code->group != 0) {
    take_modal_code(control, *code, codes);
  } else if (code->action == GAction::ExactStop) {
    control.stops_exactly = true;
  } else if (code->action != GAction::NoEffect) {
    codes.one_shot = code;
  }
  return std::nullopt;
}

/// F as a number in the unit in force, per minute or per revolution; without a point a feed per
/// revolution counts hundredths of a mm, or thousandths with parameter 1405.1 (inch: a tenth of
/// that).
double feed_of(const Control& control, const EvaluatedWord& word) {
  const bool counts = control.modal.group[5].whole == 95 &&
                      word.form == syntax::ValueForm::Integer && !control.scale.calculator_point;
  if (!counts) {
    return word.number;
  }
  const double per_mm = control.parameters.is_on(ParameterId::FineFeedPerTurn) ? 1000.0 : 100.0;
  return word.number / (control.scale.unit == LengthUnit::Inch ? per_mm * 100.0 : per_mm);
}

/// F S T M and the like: recorded for #4102.., M codes otherwise skipped.
MaybeFailure take_plain_word(Control& control, const EvaluatedWord& word) {
  switch (word.letter) {
    case 'F':
      if (word.number < 0.0) {
        return at_word(AlarmId::IllegalMinus, word, "a feed is not negative");
      }
      control.modal.feed = feed_of(control, word);
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

}  // namespace

Result<Codes, Failure> take_words(Control& control, const BlockWords& words) {
  Codes codes;
  for (const EvaluatedWord& word : words.all()) {
    if (word.letter == 'G') {
      if (auto failure = take_g_word(control, word, codes)) {
        return *std::move(failure);
      }
    }
  }
  const auto unit = control.modal.group[6].whole == 20 ? LengthUnit::Inch : LengthUnit::Millimetre;
  if (unit != control.scale.unit) {
    control.set_unit(unit);
  }
  for (const EvaluatedWord& word : words.all()) {
    if (word.letter != 'G') {
      if (auto failure = take_plain_word(control, word)) {
        return *std::move(failure);
      }
    }
  }
  return codes;
}

}  // namespace g31::fanuc

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

/// G27 to G30 have no place between holes (MB-312).
bool is_barred_in_cycle(GAction action) {
  return action == GAction::CheckReference || action == GAction::ToReference ||
         action == GAction::FromReference;
}

/// G22 with limits: the control would watch them, nothing here does.
MaybeFailure execute_stroke_check(Control& control, const NcBlock& block) {
  if (block.has_axis_word) {
    control.warn_once(source::DiagnosticId::NotSimulated, block.where, "the limits of G22");
  }
  return std::nullopt;
}

MaybeFailure execute_nothing(Control& control, const NcBlock& block) {
  control.warn_once(source::DiagnosticId::NotSimulated, block.where, to_text(block.code->number));
  return std::nullopt;
}

MaybeFailure execute_action(Control& control, const NcBlock& block) {
  if (in_canned_cycle(control) && is_barred_in_cycle(block.code->action)) {
    return block_failure(AlarmId::NotAllowedInCycle, to_text(block.code->number));
  }
  switch (block.code->action) {
    case GAction::Dwell:
      return execute_dwell(control, block);
    case GAction::SetData:
      return execute_set_data(control, block);
    case GAction::CheckReference:
      return execute_check_reference(control, block);
    case GAction::ToReference:
      return execute_reference(control, block);
    case GAction::FromReference:
      return execute_from_reference(control, block);
    case GAction::Skip:
      return execute_skip(control, block);
    case GAction::MeasureTool:
      return execute_tool_measurement(control, block);
    case GAction::MeasureDiameter:
      return execute_diameter_measurement(control, block);
    case GAction::MeasureWork:
    case GAction::MeasureCentre:
      return execute_work_measurement(control, block);
    case GAction::LocalShift:
      return execute_local_shift(control, block);
    case GAction::MachineMove:
      return execute_machine_move(control, block);
    case GAction::SetPosition:
      return execute_set_position(control, block);
    case GAction::PresetSystem:
      return execute_preset(control, block);
    case GAction::Mirror:
      return execute_mirror(control, block);
    case GAction::MirrorOff:
      return execute_mirror_off(control, block);
    case GAction::Scaling:
      return execute_scaling(control, block);
    case GAction::Rotation:
      return execute_rotation(control, block);
    case GAction::StrokeCheck:
      return execute_stroke_check(control, block);
    case GAction::EndData:
      return std::nullopt;
    case GAction::Unsimulated:
      return execute_nothing(control, block);
    case GAction::Modal:
    case GAction::NoEffect:
    case GAction::ExactStop:
    case GAction::Motion:
    case GAction::ToolLength:
    case GAction::WorkOffset:
    case GAction::MacroCall:
    case GAction::PolarOn:
    case GAction::PolarOff:
    case GAction::ScalingOff:
    case GAction::RotationOff:
    case GAction::CannedCycle:
    case GAction::CycleOff:
    case GAction::SurfaceSpeed:
    case GAction::Refused:
      break;
  }
  contract_violated("these codes leave the words of their block to others", __FILE__, __LINE__);
}

bool has_axis_word(const BlockWords& words) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (words.has(kAxisLetters[axis])) {
      return true;
    }
  }
  return false;
}

MaybeFailure select_offsets(Control& control, const BlockWords& words, const Codes& codes) {
  if (codes.work_offset != nullptr) {
    if (auto failure = select_work_offset(control, words, codes.work_offset->number)) {
      return failure;
    }
  }
  if (codes.tool_length != nullptr || words.has('H') ||
      control.parameters.is_on(ParameterId::LengthAtNextBlock)) {
    return select_tool_length(control, words);
  }
  return std::nullopt;
}

/// An arc without an end: it has a centre, so it goes round (MB-302).
bool is_full_circle(const Control& control, const NcBlock& block) {
  const int g = control.modal.group[Group::Motion].whole;
  const Plane plane = control.modal.plane();
  return (g == 2 || g == 3) &&
         (block.words.has(plane.first_centre) || block.words.has(plane.second_centre));
}

/// What the words command when the modal codes and offsets are in force.
MaybeFailure execute_words(Control& control, const NcBlock& block, double feed_before) {
  if (block.code != nullptr) {
    auto failure = execute_action(control, block);
    if (block.code->action == GAction::Skip && control.profile.skip_feed == SkipFeed::OneBlock) {
      control.modal.feed = feed_before;
    }
    return failure;
  }
  if (in_canned_cycle(control)) {
    return execute_canned_cycle(control, block);
  }
  return block.has_axis_word || is_full_circle(control, block) ? execute_motion(control, block)
                                                               : std::nullopt;
}

}  // namespace

MaybeFailure execute_block(Control& control, const BlockWords& words, source::Location where) {
  control.block = where;
  if (control.data_input != DataInput::None) {
    return execute_data_block(control, words);
  }
  const double feed_before = control.modal.feed;
  control.stops_exactly = false;
  const auto codes = take_words(control, words);
  if (!codes) {
    return codes.error();
  }
  if (auto failure = select_offsets(control, words, codes.value())) {
    return failure;
  }
  command_machine(control, words);
  if (codes.value().unsimulated != nullptr) {
    control.warn_once(source::DiagnosticId::NotSimulated, where, codes.value().unsimulated->text);
  }
  if (codes.value().starts_polar) {
    start_polar(control);
  }
  if (codes.value().starts_cycle && in_canned_cycle(control)) {
    start_canned_cycle(control);
  }
  NcBlock block{words, where, codes.value().frame, has_axis_word(words)};
  if (block.code == nullptr) {
    block.code = codes.value().one_shot;
  }
  if (auto failure = read_compensation(control, block)) {
    return failure;
  }
  if (auto failure = execute_words(control, block, feed_before)) {
    return failure;
  }
  keep_marked_point(control, words);
  return end_compensated_block(control);
}

Failure block_failure(AlarmId id, std::string detail) {
  Failure failure;
  failure.id = id;
  failure.detail = std::move(detail);
  return failure;
}

Failure at_place(AlarmId id, syntax::ShortSpan where, std::string detail) {
  Failure failure = block_failure(id, std::move(detail));
  failure.where = where;
  return failure;
}

Failure at_word(AlarmId id, const EvaluatedWord& word, std::string detail) {
  return at_place(id, word.span, std::move(detail));
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

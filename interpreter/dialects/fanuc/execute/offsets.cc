#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/spindle.h"

namespace g31::fanuc {
namespace {

/// Whether a length acts along another linear axis than this one.
bool acts_elsewhere(const AxisPositions& q_offset, int axis) {
  AxisPositions q_others = q_offset;
  q_others[axis] = 0.0;
  return !q_others.isZero(0.0);
}

/// The axis of tool length compensation C.
/// @param code  G43 or G44 of the block; nullptr: it has none
Result<int, Failure> named_length_axis(const Control& control, const NcBlock& block,
                                       const GCode* code) {
  if (code == nullptr) {
    return control.modal.length_axis;
  }
  std::optional<int> named;
  int count = 0;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    if (block.words.has(kAxisLetters[static_cast<std::size_t>(axis)])) {
      named = axis;
      ++count;
    }
  }
  if (count != 1) {
    return block_failure(AlarmId::LengthWithoutAxis,
                         fmt::format("{} names {} axes", to_text(code->number), count));
  }
  if (!control.parameters.is_on(ParameterId::LengthOnSeveralAxes) &&
      acts_elsewhere(control.coordinates.tool_offset(), *named)) {
    return block_failure(AlarmId::LengthWithoutAxis, "another axis is compensated");
  }
  return *named;
}

/// The axis that G43, G44 and H compensate.  Source: FANUC 30i connection manual B-63943EN-1/02,
/// 12.5, tool length compensation A, B and C.
Result<int, Failure> length_axis(const Control& control, const NcBlock& block, const GCode* code) {
  const GNumber in_force = control.modal.group[Group::ToolLength];
  if (in_force.tenth != 0 || in_force.whole == 49) {
    return kToolAxis;
  }
  if (control.parameters.is_on(ParameterId::LengthOnNamedAxis)) {
    return named_length_axis(control, block, code);
  }
  return control.parameters.is_on(ParameterId::LengthAcrossPlane) ? control.modal.plane().across
                                                                  : kToolAxis;
}

Failure missing(source::DiagnosticId row, std::string what) {
  Failure failure;
  failure.status = runtime::Status::Setup;
  failure.alarm_number = static_cast<int>(row);
  failure.detail = std::move(what);
  return failure;
}

/// P of G54.2 and G54.4; 0 ends them.
Result<int, Failure> number_of_error(const Control& control, const NcBlock& block) {
  const EvaluatedWord* const p = block.words.find('P');
  const auto limit = [&](int number) { return wrong_part_error(number, block.code->number); };
  return p != nullptr ? integer_within(*p, control.profile, limit) : Result<int, Failure>(1);
}

}  // namespace

/// G54 to G59, G54.1 Pn, G54 Pn (MB-292, MB-293); G110 to G129 and G154 Pn of a Haas.
MaybeFailure select_work_offset(Control& control, const BlockWords& words, GNumber code) {
  constexpr int kFirstAdditional = 110;  // G110 is G154 P1
  constexpr int kLastAdditional = 129;
  int which = code.whole - 53;
  control.modal.additional_system = 0;
  const EvaluatedWord* const p = words.find('P');
  const bool is_numbered = code.whole >= kFirstAdditional && code.whole <= kLastAdditional;
  if (is_numbered || selects_by_number(code, p != nullptr)) {
    const auto limit = [&](int p_number) {
      return wrong_work_system(p_number, code, control.profile);
    };
    const auto number = is_numbered    ? Result<int, Failure>(code.whole - kFirstAdditional + 1)
                        : p != nullptr ? integer_within(*p, control.profile, limit)
                                       : Result<int, Failure>(1);
    if (!number) {
      return number.error();
    }
    which = Coordinates::kSystems + number.value();
    control.modal.additional_system = number.value();
    if (code.whole == 54) {
      control.modal.group[Group::WorkSystem] = {54, 1};
    }
  }
  if (!control.expected_systems.empty() && !control.expected_systems.contains(which)) {
    return missing(source::DiagnosticId::SetupMissingOffset,
                   which <= Coordinates::kSystems
                       ? to_text(code)
                       : fmt::format("{} P{}", is_numbered || code.whole == 154 ? "G154" : "G54.1",
                                     which - Coordinates::kSystems));
  }
  control.coordinates.select(which);
  return std::nullopt;
}

/// G43, G44, G49, and H, which waits for one of the first two under G49 (MB-135, MB-295, MB-296).
/// @param commanded  the code of the block; nullptr: it has none
MaybeFailure select_tool_length(Control& control, NcBlock& block, const GCode* commanded) {
  const int code = control.modal.group[Group::ToolLength].whole;
  if (const EvaluatedWord* const h = block.words.find('H')) {
    const auto number = integer_within(*h, control.profile, [&control](int given) {
      return wrong_length_offset(given, control.modal.group[Group::ToolLength]);
    });
    if (!number) {
      return number.error();
    }
    control.modal.length_offset = number.value();
  } else if (commanded != nullptr && code != 49 && control.modal.length_offset == 0) {
    control.warn_once(
        source::DiagnosticId::WordWithoutEffect, control.block,
        fmt::format("{} without H, which is 0", to_text(control.modal.group[Group::ToolLength])));
  }
  const bool had_tip = control.coordinates.tip_system() != TipSystem::None;
  if (auto failure = select_tip_control(control)) {
    return failure;
  }
  const auto axis = length_axis(control, block, commanded);
  if (!axis) {
    return axis.error();
  }
  control.modal.length_axis = axis.value();
  AxisPositions q_offset =
      code == 49 ? AxisPositions(AxisPositions::Zero()) : control.coordinates.tool_offset();
  q_offset[axis.value()] = 0.0;
  const int number = control.modal.length_offset;
  if (code != 49 && number != 0) {
    if (!control.expected_tools.empty() && !control.expected_tools.contains(number) &&
        !control.offsets.has(number)) {
      return missing(source::DiagnosticId::SetupMissingTool, fmt::format("H{}", number));
    }
    if (!control.offsets.has(number)) {
      control.warn_once(source::DiagnosticId::OffsetNeverSet, control.block,
                        fmt::format("H{}", number));
    }
    const runtime::ToolEntry entry = control.offsets.get(number);
    const double length = entry.length_mm + entry.length_wear_mm;
    q_offset[axis.value()] = code == 44 ? -length : length;
  }
  const bool shifts = control.profile.length_change == LengthChange::ShiftsCoordinates ||
                      control.parameters.is_on(ParameterId::LengthShifts);
  if (shifts) {
    control.coordinates.shift_tool_offset(q_offset);
    return std::nullopt;
  }
  const bool changes = control.coordinates.set_tool_offset(q_offset);
  block.changes_length = changes && !had_tip && control.coordinates.tip_system() == TipSystem::None;
  return std::nullopt;
}

Result<double, Failure> cutter_radius(const Control& control) {
  const int number = static_cast<int>(control.modal.words['D' - 'A']);
  if (auto wrong = wrong_radius_offset(number)) {
    return block_failure(wrong->id, std::move(wrong->detail));
  }
  if (number != 0 && !control.expected_tools.empty() && !control.expected_tools.contains(number) &&
      !control.offsets.has(number)) {
    return missing(source::DiagnosticId::SetupMissingTool, fmt::format("D{}", number));
  }
  const runtime::ToolEntry entry = control.offsets.get(number);
  const double share = control.parameters.is_on(ParameterId::DiameterOffsets) ? 0.5 : 1.0;
  return number != 0 ? share * (entry.radius_mm + entry.radius_wear_mm) : 0.0;
}

/// G52: the named axes take this shift, in every work system (MB-290) or in the one in force.
MaybeFailure execute_local_shift(Control& control, const NcBlock& block) {
  control.use_measured();
  const bool adds = control.profile.shifts_each_system && control.modal.incremental();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      const int index = static_cast<int>(axis);
      const double before = adds ? control.coordinates.local_shift()[index] : 0.0;
      control.coordinates.set_local_shift(index, before + axis_value(control, *word, axis));
    }
  }
  return std::nullopt;
}

/// G92: the named axes read these values from now on (MB-294).
MaybeFailure execute_set_position(Control& control, const NcBlock& block) {
  if (const MaybeFailure failure = take_lowest_speed(control, block.words)) {
    return failure;
  }
  if (!block.has_axis_word) {
    return std::nullopt;
  }
  control.use_measured();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      control.coordinates.declare(static_cast<int>(axis), axis_value(control, *word, axis));
    }
  }
  return std::nullopt;
}

/// G92.1: on the named axes neither G52 nor G92 shifts the work systems any more.
MaybeFailure execute_preset(Control& control, const NcBlock& block) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (block.words.has(kAxisLetters[axis])) {
      control.coordinates.clear_shifts(static_cast<int>(axis));
    }
  }
  return std::nullopt;
}

namespace {

/// Parameters 7580 to 7588; nullopt: a group of other axes than a rotary one and two linear ones.
std::optional<PartErrors::TableGroups> table_groups(const Control& control) {
  PartErrors::TableGroups groups;
  int next = 0;
  for (TableGroup& group : groups) {
    const auto axis = [&control, &next] {
      return nearest_integer(control.parameters.get(ParameterId::TableOffsetAxes, next++)) - 1;
    };
    const TableGroup given{axis(), axis(), axis()};
    if (given.rotary < 0) {
      continue;
    }
    const bool is_plane = std::min(given.first, given.second) >= 0 && is_linear_axis(given.first) &&
                          is_linear_axis(given.second) && given.first != given.second;
    if (!is_rotary_axis(given.rotary) || !is_plane) {
      return std::nullopt;
    }
    group = given;
  }
  return groups;
}

}  // namespace

MaybeFailure execute_table_offset(Control& control, const NcBlock& block) {
  const auto number = number_of_error(control, block);
  if (!number) {
    return number.error();
  }
  const auto groups = table_groups(control);
  if (!groups) {
    return block_failure(AlarmId::NoReachablePosition,
                         "parameters 7580 to 7588: groups of a rotary axis and two linear ones");
  }
  PartErrors errors = control.coordinates.part_errors();
  errors.set_table_groups(*groups);
  errors.select_table_offset(number.value());
  control.coordinates.set_part_errors(errors,
                                      control.parameters.is_on(ParameterId::TurnsToolToPart));
  return std::nullopt;
}

MaybeFailure execute_setting_error(Control& control, const NcBlock& block) {
  const auto number = number_of_error(control, block);
  if (!number) {
    return number.error();
  }
  PartErrors errors = control.coordinates.part_errors();
  errors.select_setting_error(number.value());
  control.coordinates.set_part_errors(errors,
                                      control.parameters.is_on(ParameterId::TurnsToolToPart));
  return std::nullopt;
}

}  // namespace g31::fanuc

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

/// In inches offsets have one digit less before the point.
constexpr double kInchLimit = 2.54;

constexpr int kToolLife = 3;
/// L52 where programs of newer controls write it.
constexpr int kParameterInput[] = {50, 52};

/// What `G10 L..` sets in the tool offset table, and the first memory, from A on, that has it
/// (MB-257, MB-258).
struct OffsetForm {
  int l;
  double runtime::ToolEntry::*field;
  OffsetMemory from;
};

constexpr OffsetForm kOffsetForms[] = {{1, &runtime::ToolEntry::length_wear_mm, OffsetMemory::A},
                                       {10, &runtime::ToolEntry::length_mm, OffsetMemory::B},
                                       {11, &runtime::ToolEntry::length_wear_mm, OffsetMemory::A},
                                       {12, &runtime::ToolEntry::radius_mm, OffsetMemory::C},
                                       {13, &runtime::ToolEntry::radius_wear_mm, OffsetMemory::C}};

MaybeFailure set_tool_offset(Control& control, const NcBlock& block, const OffsetForm& form) {
  const EvaluatedWord* const p = block.words.find('P');
  const EvaluatedWord* const r = block.words.find('R');
  if (p == nullptr || r == nullptr) {
    return p == nullptr ? block_failure(AlarmId::DataInputFormat, "P is missing")
                        : block_failure(AlarmId::NoValueInG10, "R is missing");
  }
  const auto number = integer_of(*p);
  if (!number) {
    return number.error();
  }
  if (number.value() < 1 || number.value() > OffsetTable::kLargest) {
    return at_word(AlarmId::IllegalPInG10, *p, "P is 1 to 999");
  }
  const runtime::ToolEntry entry = control.offsets.get(number.value());
  const double before = control.modal.incremental() ? entry.*form.field : 0.0;
  const double value = before + control.scale.length_mm(*r);
  const double most =
      control.profile.offset_limit_mm * (control.scale.unit == LengthUnit::Inch ? kInchLimit : 1.0);
  if (std::abs(value) >= most) {
    return at_word(AlarmId::IllegalValueInG10, *r,
                   fmt::format("an offset must be below {:g} mm", most));
  }
  control.offsets.set_field(number.value(), form.field, value);
  return std::nullopt;
}

/// G10 L2 P0..P6 and L20 P1..P300; axes that are not named keep their value.
MaybeFailure set_work_offset(Control& control, const NcBlock& block, int l) {
  const EvaluatedWord* const p = block.words.find('P');
  const auto number = p != nullptr ? integer_of(*p) : Result<int, Failure>(l == 2 ? 0 : 1);
  if (!number) {
    return number.error();
  }
  const int lowest = l == 2 ? 0 : 1;
  const int highest = l == 2 ? Coordinates::kSystems : Coordinates::kAdditional;
  if (number.value() < lowest || number.value() > highest) {
    return at_word(AlarmId::IllegalPInG10, *p, fmt::format("P is {} to {}", lowest, highest));
  }
  const int which = number.value() + (l == 2 ? 0 : Coordinates::kSystems);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      const double value = axis_value(control, *word, axis);
      const int index = static_cast<int>(axis);
      const double before =
          control.modal.incremental() ? control.coordinates.system(which)[index] : 0.0;
      control.coordinates.set_system(which, index, before + value);
    }
  }
  control.expected_systems.insert(which);
  return std::nullopt;
}

/// G10 L21 P1..P8: where a part lies on the table otherwise than it should, and the positions of
/// the rotary axes at which that was found.
MaybeFailure set_table_offset(Control& control, const NcBlock& block) {
  const EvaluatedWord* const p = block.words.find('P');
  const auto number = p != nullptr ? integer_of(*p) : Result<int, Failure>(0);
  if (!number) {
    return number.error();
  }
  if (number.value() < 1 || number.value() > PartErrors::kTableOffsets) {
    return block_failure(AlarmId::IllegalPInG10,
                         fmt::format("P of G10 L21 is 1 to {}", PartErrors::kTableOffsets));
  }
  PartErrors errors = control.coordinates.part_errors();
  AxisPositions q_offset = errors.table_offset(number.value());
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      double& value = q_offset[static_cast<Eigen::Index>(axis)];
      value = (control.modal.incremental() ? value : 0.0) + axis_value(control, *word, axis);
    }
  }
  errors.set_table_offset(number.value(), q_offset);
  control.coordinates.set_part_errors(errors,
                                      control.parameters.is_on(ParameterId::TurnsToolToPart));
  return std::nullopt;
}

}  // namespace

MaybeFailure execute_set_data(Control& control, const NcBlock& block) {
  control.use_measured();
  const EvaluatedWord* const word = block.words.find('L');
  const auto l = word != nullptr ? integer_of(*word) : Result<int, Failure>(1);
  if (!l) {
    return l.error();
  }
  if (std::ranges::find(kParameterInput, l.value()) != std::end(kParameterInput)) {
    control.data_input = DataInput::Parameters;
    return std::nullopt;
  }
  if (l.value() == kToolLife) {
    const EvaluatedWord* const p = block.words.find('P');
    constexpr double kDeletes = 2.0;
    control.data_input = DataInput::ToolLife;
    control.life_group = {0, 0.0, p != nullptr && p->number == kDeletes};
    control.warn_once(source::DiagnosticId::NotSimulated, block.where, "tool life management");
    return std::nullopt;
  }
  if (l.value() == 2 || l.value() == 20) {
    return set_work_offset(control, block, l.value());
  }
  constexpr int kTableOffset = 21;
  constexpr GNumber kTableOffsetCode{54, 2};
  if (l.value() == kTableOffset && has_g_code(control.profile, *find_g_code(kTableOffsetCode))) {
    return set_table_offset(control, block);
  }
  for (const OffsetForm& form : kOffsetForms) {
    if (form.l == l.value() && control.offsets.memory() >= form.from) {
      return set_tool_offset(control, block, form);
    }
  }
  return at_word(AlarmId::DataInputFormat, *word, fmt::format("G10 has no L{} here", l.value()));
}

}  // namespace g31::fanuc

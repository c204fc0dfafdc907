#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/code/data_setting.h"
#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

MaybeFailure set_tool_offset(Control& control, const NcBlock& block, const OffsetForm& form) {
  for (const EvaluatedWord& word : block.words.all()) {
    if (auto failure = at_word(foreign_to_offset(word.letter, form.l), word)) {
      return failure;
    }
  }
  const EvaluatedWord* const p = block.words.find('P');
  const EvaluatedWord* const r = block.words.find('R');
  if (auto wrong = missing_offset_word(p != nullptr, r != nullptr)) {
    return block_failure(wrong->id, std::move(wrong->detail));
  }
  const auto number = integer_within(*p, control.profile, [&](int given) {
    return wrong_data_number(form.l, given, control.profile);
  });
  if (!number) {
    return number.error();
  }
  const runtime::ToolEntry entry = control.offsets.get(number.value());
  const double before = control.modal.incremental() ? entry.*form.field : 0.0;
  const double share = form.is_radius && control.profile.enters_diameters ? 0.5 : 1.0;
  const double value = before + share * control.scale.length_mm(*r);
  const double most = control.offset_limit_mm();
  if (std::abs(value) >= most) {
    return at_word(AlarmId::IllegalValueInG10, *r,
                   fmt::format("an offset must be below {:g} mm", most));
  }
  control.offsets.set_field(number.value(), form.field, value);
  return std::nullopt;
}

/// P of G10 L2 and L20 where there is none.
int usual_system(const Control& control, int l) {
  if (!control.profile.sets_system_in_force) {
    return l == 2 ? 0 : 1;
  }
  const int selected = control.coordinates.selected();
  return selected - (l == 2 ? 0 : Coordinates::kSystems);
}

/// G10 L2 P0..P6 and L20 P1..P300; axes that are not named keep their value.
MaybeFailure set_work_offset(Control& control, const NcBlock& block, int l) {
  const EvaluatedWord* const p = block.words.find('P');
  const auto number =
      p != nullptr
          ? integer_within(*p, control.profile,
                           [&](int given) { return wrong_data_number(l, given, control.profile); })
          : Result<int, Failure>(usual_system(control, l));
  if (!number) {
    return number.error();
  }
  const int which = number.value() + (l == 2 ? 0 : Coordinates::kSystems);
  // Number 0 is what #5201 shows.  Source: Haas mill operator's manual, G10: P0 is G52
  const bool is_local = which == 0 && control.profile.variables.meets({VariableGroup::ShiftAt5201});
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      const double value = axis_value(control, *word, axis);
      const int index = static_cast<int>(axis);
      const AxisPositions& now =
          is_local ? control.coordinates.local_shift() : control.coordinates.system(which);
      const double entered = (control.modal.incremental() ? now[index] : 0.0) + value;
      is_local ? control.coordinates.set_local_shift(index, entered)
               : control.coordinates.set_system(which, index, entered);
    }
  }
  control.work_offset_given(which);
  return std::nullopt;
}

/// G10 L21 P1..P8: where a part lies on the table otherwise than it should, and the positions of
/// the rotary axes at which that was found.
MaybeFailure set_table_offset(Control& control, const NcBlock& block) {
  const EvaluatedWord* const p = block.words.find('P');
  const auto number = p != nullptr ? integer_of(*p, control.profile) : Result<int, Failure>(0);
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
  const auto l = word != nullptr ? integer_of(*word, control.profile)
                                 : Result<int, Failure>(usual_data(block.words, control.profile));
  if (!l) {
    return l.error();
  }
  if (sets_parameters(l.value()) && ends_data(control.profile)) {
    control.data_input = DataInput::Parameters;
    return std::nullopt;
  }
  if (l.value() == kToolLifeData && ends_data(control.profile)) {
    const EvaluatedWord* const p = block.words.find('P');
    constexpr double kDeletes = 2.0;
    control.data_input = DataInput::ToolLife;
    control.life_group = {0, 0.0, p != nullptr && p->number == kDeletes};
    control.warn_once(source::DiagnosticId::NotSimulated, block.where, "tool life management");
    return std::nullopt;
  }
  if (sets_work_offset(l.value())) {
    return set_work_offset(control, block, l.value());
  }
  constexpr int kTableOffset = 21;
  constexpr GNumber kTableOffsetCode{54, 2};
  if (l.value() == kTableOffset && find_g_code(kTableOffsetCode, control.profile) != nullptr) {
    return set_table_offset(control, block);
  }
  const OffsetForm* const form = find_offset_form(l.value(), control.offsets.memory());
  return form != nullptr ? set_tool_offset(control, block, *form)
                         : at_word(AlarmId::UnknownDataInG10, *word,
                                   fmt::format("G10 has no L{} here", l.value()));
}

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/control_variables.h"

#include <cmath>

#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

constexpr int kNumbersPerSystem = 20;
constexpr double kMsPerHour = 3.6e6;

/// What a system variable takes at most: far beyond any machine, and every sum of them is finite.
constexpr double kLargestValue = 4'294'967'295.0;

using Id = SystemVariableId;

/// The work offset (as Coordinates counts them) and the axis that a number of the row means.
struct OffsetPlace {
  int system;
  int axis;
};

OffsetPlace offset_place(const SystemVariable& row, std::int32_t number) {
  const int index = number - row.first;
  const int first = row.id == Id::ExternalOffset ? 0
                    : row.id == Id::WorkOffset   ? 1
                                                 : Coordinates::kSystems + 1;
  return {first + index / kNumbersPerSystem, index % kNumbersPerSystem};
}

bool is_work_offset(Id id) {
  return id == Id::ExternalOffset || id == Id::WorkOffset || id == Id::AdditionalLow ||
         id == Id::AdditionalHigh;
}

bool is_tool_offset(Id id) {
  return id == Id::LengthWear || id == Id::LengthGeometry || id == Id::LengthWearLong ||
         id == Id::LengthGeometryLong || id == Id::RadiusWear || id == Id::RadiusGeometry;
}

/// The field of an offset entry that a row shows.
double runtime::ToolEntry::*field_of(Id id) {
  if (id == Id::LengthWear || id == Id::LengthWearLong) {
    return &runtime::ToolEntry::length_wear_mm;
  }
  if (id == Id::RadiusWear) {
    return &runtime::ToolEntry::radius_wear_mm;
  }
  return id == Id::RadiusGeometry ? &runtime::ToolEntry::radius_mm : &runtime::ToolEntry::length_mm;
}

/// The letter that #4102 to #4120 show, in alphabetical places: 4102 B ... 4120 T.
char modal_letter(std::int32_t number) {
  return static_cast<char>('A' + (number - 4101));
}

}  // namespace

Result<Cell, AlarmId> ControlVariables::read(std::int32_t number) {
  const SystemVariable* const row = find_system_variable(number);
  if (row == nullptr) {
    return AlarmId::IllegalVariable;
  }
  if (row->access == Access::Write) {
    return AlarmId::ReadProtected;
  }
  const Control& control = *control_;
  if (is_tool_offset(row->id)) {
    return Cell(control.from_mm(tool_offset(*row, number)));
  }
  if (row->id == Id::ModalGroup) {
    return Cell(control.modal.group[static_cast<std::size_t>(number - 4000)].value());
  }
  if (row->id == Id::ModalWord) {
    return Cell(read_modal(number));
  }
  if (row->id == Id::Timer || row->id == Id::CycleHours) {
    const double ms = control.port.time_s() * 1000.0 + control.timer_offset_ms;
    return Cell(row->id == Id::Timer ? std::floor(ms) : control.port.time_s() * 1000.0 / kMsPerHour);
  }
  if (row->id == Id::SingleBlock || row->id == Id::Override) {
    return Cell(row->id == Id::SingleBlock ? control.single_block_control : control.override_control);
  }
  if (is_work_offset(row->id)) {
    const OffsetPlace place = offset_place(*row, number);
    if (place.axis >= static_cast<int>(kAxisCount)) {
      return AlarmId::IllegalVariable;
    }
    return Cell(control.from_mm(control.coordinates.system(place.system)[place.axis]));
  }
  return read_axis(*row, number - row->first);
}

Result<Cell, AlarmId> ControlVariables::read_axis(const SystemVariable& row, int axis) const {
  if (axis >= static_cast<int>(kAxisCount)) {
    return AlarmId::IllegalVariable;
  }
  const Control& control = *control_;
  const auto shown = [&](const AxisPositions& q) {
    return Cell(axis < 3 ? control.from_mm(q[axis]) : q[axis]);
  };
  if (row.id == Id::BlockEnd) {
    return shown(control.coordinates.programmed());
  }
  if (row.id == Id::MachinePosition) {
    return shown(control.port.position());
  }
  if (row.id == Id::WorkPosition) {
    return shown(control.coordinates.to_work(control.port.position()));
  }
  if (row.id == Id::SkipPosition) {
    control_->report_silent_skip();
    return shown(control.q_W_skip);
  }
  G31_EXPECTS(row.id == Id::ToolOffset);
  return shown(control.coordinates.tool_offset());
}

double ControlVariables::read_modal(std::int32_t number) const {
  if (number == 4109) {
    return control_->modal.feed;
  }
  if (number == 4111) {
    return control_->modal.length_offset;
  }
  if (number == 4130) {
    return control_->modal.additional_system;
  }
  return control_->modal.word(modal_letter(number));
}

double ControlVariables::tool_offset(const SystemVariable& row, std::int32_t number) const {
  return control_->offsets.get(number - row.first + 1).*field_of(row.id);
}

std::optional<AlarmId> ControlVariables::set_tool_offset(const SystemVariable& row,
                                                         std::int32_t number, double value) {
  const int entry_number = number - row.first + 1;
  runtime::ToolEntry entry = control_->offsets.get(entry_number);
  entry.*field_of(row.id) = control_->to_mm(value);
  control_->offsets.set(entry_number, entry);
  return std::nullopt;
}

std::optional<AlarmId> ControlVariables::set_work_offset(const SystemVariable& row,
                                                         std::int32_t number, double value) {
  const OffsetPlace place = offset_place(row, number);
  if (place.axis >= static_cast<int>(kAxisCount)) {
    return AlarmId::IllegalVariable;
  }
  control_->coordinates.set_system(place.system, place.axis,
                                   place.axis < 3 ? control_->to_mm(value) : value);
  return std::nullopt;
}

std::optional<AlarmId> ControlVariables::write(std::int32_t number, Cell value) {
  const SystemVariable* const row = find_system_variable(number);
  if (row == nullptr) {
    return AlarmId::IllegalVariable;
  }
  if (row->access == Access::Read) {
    return AlarmId::WriteProtected;
  }
  const double plain = value.or_zero();
  if (std::abs(plain) > kLargestValue) {
    return AlarmId::IllegalOffsetValue;
  }
  if (is_tool_offset(row->id)) {
    return set_tool_offset(*row, number, plain);
  }
  if (is_work_offset(row->id)) {
    return set_work_offset(*row, number, plain);
  }
  if (row->id == Id::Timer) {
    control_->timer_offset_ms = plain - control_->port.time_s() * 1000.0;
  } else if (row->id == Id::SingleBlock) {
    control_->single_block_control = nearest_integer(plain);
  } else if (row->id == Id::Override) {
    control_->override_control = nearest_integer(plain);
  }
  return std::nullopt;
}

}  // namespace g31::fanuc

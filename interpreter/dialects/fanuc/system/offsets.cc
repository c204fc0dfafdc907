#include <cmath>

#include "interpreter/dialects/fanuc/system/access.h"
#include "machine/base/contract.h"

namespace g31::fanuc::system {
namespace {

constexpr int kNumbersPerLegacyAxis = 100;
constexpr int kFirstLegacy = 2500;

/// What a tool offset variable shows: a field, times 2 where the control keeps diameters.
struct EntryView {
  OffsetTable::Field field;
  double factor = 1.0;
};

EntryView view_of(Shows shows) {
  using runtime::ToolEntry;
  if (shows == Shows::LengthGeometry || shows == Shows::LengthWear) {
    return {shows == Shows::LengthWear ? &ToolEntry::length_wear_mm : &ToolEntry::length_mm};
  }
  if (shows == Shows::RadiusGeometry || shows == Shows::RadiusWear) {
    return {shows == Shows::RadiusWear ? &ToolEntry::radius_wear_mm : &ToolEntry::radius_mm};
  }
  G31_EXPECTS(shows == Shows::DiameterGeometry || shows == Shows::DiameterWear);
  return {shows == Shows::DiameterWear ? &ToolEntry::radius_wear_mm : &ToolEntry::radius_mm, 2.0};
}

/// A work offset, as Coordinates counts them, and one of its axes.
struct OffsetPlace {
  int system;
  int axis;
};

std::optional<OffsetPlace> offset_place(const Control& control, const Place& place) {
  OffsetPlace found{};
  if (place.row.shows == Shows::LegacyOffset) {
    const int index = place.number - kFirstLegacy;
    found = {index % kNumbersPerLegacyAxis, index / kNumbersPerLegacyAxis};
  } else if (place.row.shows == Shows::AdditionalOffset) {
    found = {Coordinates::kSystems + 1 + place.index() / kNumbersPerSystem,
             place.index() % kNumbersPerSystem};
  } else {
    const int index = place.number - kFirstWorkOffset;
    found = {index / kNumbersPerSystem, index % kNumbersPerSystem};
  }
  const auto axis = control.controlled_axis(found.axis);
  return axis ? std::optional(OffsetPlace{found.system, *axis}) : std::nullopt;
}

}  // namespace

ReadResult read_tool_entry(Control& control, const Place& place) {
  const EntryView view = view_of(place.row.shows);
  return Cell(without_noise(
      control.from_mm(control.offsets.get(place.index() + 1).*view.field * view.factor)));
}

WriteResult write_tool_entry(Control& control, const Place& place, Cell value) {
  control.use_measured();
  const EntryView view = view_of(place.row.shows);
  const double entry = control.to_mm(value.or_zero()) / view.factor;
  if (std::abs(entry) >= control.offset_limit_mm()) {
    return AlarmId::IllegalValueInG10;  // whose text on the control names variables as well
  }
  control.offsets.set_field(place.index() + 1, view.field, entry);
  return std::nullopt;
}

ReadResult read_work_offset(Control& control, const Place& place) {
  const auto offset = offset_place(control, place);
  if (!offset) {
    return AlarmId::IllegalVariable;
  }
  return Cell(
      control.shown(offset->axis, control.coordinates.system(offset->system)[offset->axis]));
}

WriteResult write_work_offset(Control& control, const Place& place, Cell value) {
  control.use_measured();
  const auto offset = offset_place(control, place);
  if (!offset) {
    return AlarmId::IllegalVariable;
  }
  control.coordinates.set_system(offset->system, offset->axis,
                                 control.stored(offset->axis, value.or_zero()));
  control.work_offset_given(offset->system);
  return std::nullopt;
}

ReadResult read_local_shift(Control& control, const Place& place) {
  const auto axis = control.controlled_axis(place.index());
  return axis ? ReadResult(Cell(control.shown(*axis, control.coordinates.local_shift()[*axis])))
              : AlarmId::IllegalVariable;
}

WriteResult write_local_shift(Control& control, const Place& place, Cell value) {
  control.use_measured();
  const auto axis = control.controlled_axis(place.index());
  if (!axis) {
    return AlarmId::IllegalVariable;
  }
  control.coordinates.set_local_shift(*axis, control.stored(*axis, value.or_zero()));
  return std::nullopt;
}

namespace {

constexpr int kCellsOfError = 10;
constexpr int kFirstAngle = 3;
constexpr int kFirstTablePosition = 6;
constexpr int kUsedCells = 8;

/// The number of an error in the unit in force; nullptr: the cell holds none.
double* cell_of(SettingError& error, int cell) {
  if (cell >= kUsedCells) {
    return nullptr;
  }
  if (cell >= kFirstTablePosition) {
    return &error.table_deg.at(static_cast<std::size_t>(cell - kFirstTablePosition));
  }
  return cell >= kFirstAngle ? &error.turn_deg[cell - kFirstAngle] : &error.shift[cell];
}

}  // namespace

ReadResult read_setting_error(Control& control, const Place& place) {
  SettingError error =
      control.coordinates.part_errors().setting_error(place.index() / kCellsOfError);
  const int cell = place.index() % kCellsOfError;
  const double* const number = cell_of(error, cell);
  if (number == nullptr) {
    return AlarmId::IllegalVariable;
  }
  return Cell(cell < kFirstAngle ? control.from_mm(*number) : *number);
}

WriteResult write_setting_error(Control& control, const Place& place, Cell value) {
  constexpr double kMost = 1e5;
  PartErrors errors = control.coordinates.part_errors();
  const int n = place.index() / kCellsOfError;
  SettingError error = errors.setting_error(n);
  const int cell = place.index() % kCellsOfError;
  double* const number = cell_of(error, cell);
  if (number == nullptr) {
    return AlarmId::IllegalVariable;
  }
  *number = cell < kFirstAngle ? control.to_mm(value.or_zero()) : value.or_zero();
  if (!(std::abs(*number) <= kMost)) {
    return AlarmId::IllegalOffsetValue;
  }
  errors.set_setting_error(n, error);
  control.use_measured();
  control.coordinates.set_part_errors(errors,
                                      control.parameters.is_on(ParameterId::TurnsToolToPart));
  return std::nullopt;
}

}  // namespace g31::fanuc::system

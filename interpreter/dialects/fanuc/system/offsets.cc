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

std::optional<OffsetPlace> offset_place(const Place& place) {
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
  return found.axis < static_cast<int>(kAxisCount) ? std::optional(found) : std::nullopt;
}

}  // namespace

ReadResult read_tool_entry(Control& control, const Place& place) {
  const EntryView view = view_of(place.row.shows);
  return Cell(control.from_mm(control.offsets.get(place.index() + 1).*view.field * view.factor));
}

WriteResult write_tool_entry(Control& control, const Place& place, Cell value) {
  control.use_measured();
  const EntryView view = view_of(place.row.shows);
  control.offsets.set_field(place.index() + 1, view.field,
                            control.to_mm(value.or_zero()) / view.factor);
  return std::nullopt;
}

ReadResult read_work_offset(Control& control, const Place& place) {
  const auto offset = offset_place(place);
  if (!offset) {
    return AlarmId::IllegalVariable;
  }
  return Cell(
      control.shown(offset->axis, control.coordinates.system(offset->system)[offset->axis]));
}

WriteResult write_work_offset(Control& control, const Place& place, Cell value) {
  control.use_measured();
  const auto offset = offset_place(place);
  if (!offset) {
    return AlarmId::IllegalVariable;
  }
  control.coordinates.set_system(offset->system, offset->axis,
                                 control.stored(offset->axis, value.or_zero()));
  return std::nullopt;
}

ReadResult read_local_shift(Control& control, const Place& place) {
  const int axis = place.index();
  if (axis >= static_cast<int>(kAxisCount)) {
    return AlarmId::IllegalVariable;
  }
  return Cell(control.shown(axis, control.coordinates.local_shift()[axis]));
}

WriteResult write_local_shift(Control& control, const Place& place, Cell value) {
  control.use_measured();
  const int axis = place.index();
  if (axis >= static_cast<int>(kAxisCount)) {
    return AlarmId::IllegalVariable;
  }
  control.coordinates.set_local_shift(axis, control.stored(axis, value.or_zero()));
  return std::nullopt;
}

}  // namespace g31::fanuc::system

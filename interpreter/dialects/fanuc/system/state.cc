#include <cmath>
#include <numbers>

#include "interpreter/dialects/fanuc/system/access.h"

namespace g31::fanuc::system {
namespace {

constexpr double kMsPerSecond = 1000.0;
constexpr double kSecondsPerHour = 3600.0;
constexpr double kMsGuard = 1e-6;            // a sum of times such as 20 x 0.1 s is a full count
constexpr double kTimerWrap = 2147483648.0;  // ms (MB-125)

/// A bit of #3005 and the parameter that holds it (MB-129).
struct Setting {
  int bit;
  ParameterId parameter;
};
constexpr Setting kSettings[] = {{0, ParameterId::VerticalParity},
                                 {1, ParameterId::IsoCode},
                                 {2, ParameterId::InchInput},
                                 {5, ParameterId::SequenceInsertion},
                                 {9, ParameterId::TapeFormat}};

constexpr std::int32_t kAliasesOfThousand = 1000;  // #10100 and #100100 are #100

ParameterId parts_parameter(const Place& place) {
  return place.row.shows == Shows::PartsCount ? ParameterId::PartsCount
                                              : ParameterId::PartsRequired;
}

}  // namespace

ReadResult read_timer(Control& control, const Place&) {
  const double ms = control.time_looked_at() * kMsPerSecond + control.timer_offset_ms;
  return Cell(std::floor(std::fmod(ms + kMsGuard, kTimerWrap)));
}

WriteResult write_timer(Control& control, const Place&, Cell value) {
  control.timer_offset_ms = value.or_zero() - control.port.time_s() * kMsPerSecond;
  return std::nullopt;
}

ReadResult read_hours(Control& control, const Place&) {
  return Cell(control.time_looked_at() / kSecondsPerHour + control.hours_offset);
}

WriteResult write_hours(Control& control, const Place&, Cell value) {
  control.hours_offset = value.or_zero() - control.port.time_s() / kSecondsPerHour;
  return std::nullopt;
}

ReadResult read_single_block(Control& control, const Place&) {
  return Cell(control.single_block_control);
}

WriteResult write_single_block(Control& control, const Place&, Cell value) {
  control.single_block_control = nearest_integer(value.or_zero());
  return std::nullopt;
}

ReadResult read_override(Control& control, const Place&) {
  return Cell(control.override_control);
}

WriteResult write_override(Control& control, const Place&, Cell value) {
  control.override_control = nearest_integer(value.or_zero());
  return std::nullopt;
}

ReadResult read_settings(Control& control, const Place&) {
  int settings = 0;
  for (const Setting& setting : kSettings) {
    settings |= control.parameters.is_on(setting.parameter) ? 1 << setting.bit : 0;
  }
  return Cell(settings);
}

WriteResult write_settings(Control& control, const Place&, Cell value) {
  const int settings = nearest_integer(value.or_zero());
  Parameters parameters = control.parameters;
  for (const Setting& setting : kSettings) {
    parameters.switch_to(setting.parameter, (settings >> setting.bit & 1) != 0);
  }
  control.apply(parameters);
  return std::nullopt;
}

/// Setting 9 of a Haas.  Published probing suites for it ask #20009 EQ 0 for inches and EQ 1 for
/// millimetres.
ReadResult read_unit(Control& control, const Place&) {
  return Cell(control.scale.unit == LengthUnit::Inch ? 0.0 : 1.0);
}

WriteResult write_unit(Control& control, const Place&, Cell value) {
  control.set_unit(value.or_zero() == 0.0 ? LengthUnit::Inch : LengthUnit::Millimetre);
  return std::nullopt;
}

ReadResult read_mirror(Control& control, const Place&) {
  return Cell(control.mirror_state);
}

WriteResult write_mirror(Control& control, const Place&, Cell value) {
  control.mirror_state = nearest_integer(value.or_zero());
  return std::nullopt;
}

ReadResult read_restart(Control& control, const Place&) {
  return Cell(control.restart_state);
}

WriteResult write_restart(Control& control, const Place&, Cell value) {
  control.restart_state = value.or_zero() != 0.0 ? 1 : 0;
  return std::nullopt;
}

ReadResult read_date(Control& control, const Place&) {
  return Cell(control.calendar.date(control.time_looked_at()));
}

WriteResult write_date(Control& control, const Place&, Cell value) {
  return control.calendar.start_on(value.or_zero()) ? std::nullopt
                                                    : WriteResult(AlarmId::WriteProtected);
}

ReadResult read_time_of_day(Control& control, const Place&) {
  return Cell(control.calendar.time_of_day(control.time_looked_at()));
}

WriteResult write_time_of_day(Control& control, const Place&, Cell value) {
  return control.calendar.start_at(value.or_zero()) ? std::nullopt
                                                    : WriteResult(AlarmId::WriteProtected);
}

ReadResult read_constant(Control&, const Place& place) {
  constexpr double kNextGeneration = 1'000'000.0;
  if (place.row.shows == Shows::Null) {
    return Cell();
  }
  return Cell(place.row.shows == Shows::NextGeneration ? kNextGeneration
              : place.row.shows == Shows::Pi           ? std::numbers::pi
                                                       : std::numbers::e);
}

ReadResult read_parts(Control& control, const Place& place) {
  return Cell(control.parameters.get(parts_parameter(place)));
}

WriteResult write_parts(Control& control, const Place& place, Cell value) {
  control.parameters.set(parts_parameter(place), value.or_zero());
  return std::nullopt;
}

ReadResult read_further_common(Control& control, const Place& place) {
  const auto found = control.further_commons.find(place.number);
  return found != control.further_commons.end() ? found->second : Cell();
}

WriteResult write_further_common(Control& control, const Place& place, Cell value) {
  control.further_commons[place.number] = value;
  return std::nullopt;
}

ReadResult read_alias(Control& control, const Place& place) {
  const std::int32_t common = place.number % kAliasesOfThousand;
  return is_common(common) ? ReadResult(control.variables.common(common))
                           : read_further_common(control, place);
}

WriteResult write_alias(Control& control, const Place& place, Cell value) {
  const std::int32_t common = place.number % kAliasesOfThousand;
  return is_common(common) ? control.all_variables.write(common, value)
                           : write_further_common(control, place, value);
}

WriteResult write_nothing(Control&, const Place&, Cell) {
  return std::nullopt;
}

}  // namespace g31::fanuc::system

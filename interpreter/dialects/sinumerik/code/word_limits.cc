#include "interpreter/dialects/sinumerik/code/word_limits.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace g31::sinumerik {
namespace {

MaybeWrong wrong(AlarmId id, std::string detail) {
  return WrongValue{id, std::move(detail)};
}

/// Whether a value is none of the whole numbers of a range.
bool is_none_of(double value, double least, double most) {
  return value < least || value > most || value != std::floor(value);
}

}  // namespace

WrongValue out_of_range(std::string_view name, double value, const ValueRange& range) {
  return {AlarmId::ValueOutOfLimits,
          fmt::format("{}={:g}: {:g} to {:g}", name, value, range.least, range.most)};
}

MaybeWrong wrong_axis_setting(const AxisWordInfo& row, int axis, double value) {
  if (row.role == AxisRole::AxisSwitch && !is_length_axis(axis)) {
    return wrong(AlarmId::BadAxisIndex, fmt::format("{}[{}]", row.name, letter_of_axis(axis)));
  }
  const ValueRange range{row.least, row.most};
  const bool is_negative_feed = row.id == AxisWordId::AxisFeed && value < 0.0;
  if (range.holds(value) && !is_negative_feed) {
    return std::nullopt;
  }
  const std::string name = fmt::format("{}[{}]", row.name, letter_of_axis(axis));
  return is_negative_feed ? wrong(AlarmId::NegativeAxisFeed, fmt::format("{}={:g}", name, value))
                          : out_of_range(name, value, range);
}

WrongValue only_zero(Address address, double value) {
  return {AlarmId::NotImplemented, fmt::format("{}={:g}", name_of(address), value)};
}

MaybeWrong wrong_alarm_number(double number) {
  constexpr double kFirst = 60000.0;
  constexpr double kLast = 69999.0;
  return number < kFirst || number > kLast
             ? wrong(AlarmId::ValueOutOfLimits, fmt::format("SETAL({:.0f})", number))
             : std::nullopt;
}

MaybeWrong wrong_master_spindle(double number) {
  return number < 1.0 || number > kMostSpindles
             ? wrong(AlarmId::ValueOutOfLimits, fmt::format("SETMS({:g})", number))
             : std::nullopt;
}

MaybeWrong wrong_action_number(double number) {
  constexpr double kMost = 255.0;
  return number < 1.0 || number > kMost
             ? wrong(AlarmId::ValueOutOfLimits, fmt::format("ID={:g}: 1 to 255", number))
             : std::nullopt;
}

WrongValue outside_of_action(ProcedureId id) {
  return {AlarmId::SyntaxInText, fmt::format("{} stands in synchronised actions",
                                             procedures()[static_cast<std::size_t>(id)].name)};
}

MaybeWrong wrong_tool(double number) {
  constexpr double kMost = 1e8;
  return is_none_of(number, 0.0, kMost) ? wrong(AlarmId::BadTNumber, fmt::format("T{}", number))
                                        : std::nullopt;
}

MaybeWrong wrong_edge(double number) {
  constexpr double kMost = 32000.0;
  return is_none_of(number, 0.0, kMost) ? wrong(AlarmId::BadDNumber, fmt::format("D{}", number))
                                        : std::nullopt;
}

MaybeWrong wrong_additive(double number) {
  constexpr double kMost = 6.0;
  return is_none_of(number, 0.0, kMost)
             ? wrong(AlarmId::NoAdditiveOffset, fmt::format("DL={:g}", number))
             : std::nullopt;
}

MaybeWrong wrong_thread_angle(double degrees) {
  constexpr double kFullTurn = 360.0;
  return degrees >= 0.0 && degrees < kFullTurn
             ? std::nullopt
             : wrong(AlarmId::ValueOutOfLimits, fmt::format("SF={:g}: 0 to 359.999", degrees));
}

WrongValue no_feed() {
  return {AlarmId::NoFeed, ""};
}

MaybeWrong wrong_dwell(double seconds) {
  constexpr double kLongest = 1e9;
  return seconds >= 0.0 && seconds <= kLongest
             ? std::nullopt
             : wrong(AlarmId::ValueOutOfLimits, fmt::format("G4, {:g} s", seconds));
}

/// Source: programming manual, fundamentals: G4 stands in a block of its own.
WrongValue axis_beside_dwell() {
  return {AlarmId::SyntaxInText, "G4 stands in a block of its own, without an axis"};
}

MaybeWrong wrong_fixed_point(double number) {
  return is_none_of(number, 1.0, kFixedPoints)
             ? wrong(AlarmId::ValueOutOfLimits, fmt::format("FP={:g}", number))
             : std::nullopt;
}

MaybeWrong wrong_corner(double size) {
  return size < 0.0 ? wrong(AlarmId::ValueOutOfLimits, fmt::format("{:g}", size)) : std::nullopt;
}

WrongValue second_corner() {
  return {AlarmId::UnexpectedParameter, "only one of RND, CHF and CHR in a block"};
}

MaybeWrong wrong_polar_angle(double degrees) {
  constexpr double kMost = 360.0;
  return std::abs(degrees) > kMost ? wrong(AlarmId::PolarAngle, fmt::format("AP={:g}", degrees))
                                   : std::nullopt;
}

MaybeWrong wrong_polar_radius(double radius) {
  return radius < 0.0 ? wrong(AlarmId::PolarRadius, fmt::format("RP={:g}", radius)) : std::nullopt;
}

MaybeWrong wrong_turns(double turns) {
  constexpr double kMost = 999.0;
  return is_none_of(turns, 0.0, kMost)
             ? wrong(AlarmId::ValueOutOfLimits, fmt::format("TURN={:g}", turns))
             : std::nullopt;
}

WrongValue wrong_opening_angle(double degrees) {
  return {AlarmId::BadOpeningAngle, fmt::format("AR={:.4f}", degrees)};
}

MaybeWrong wrong_trigger(std::string_view word, double trigger) {
  return is_none_of(std::abs(trigger), 1.0, kMostProbes)
             ? wrong(AlarmId::ValueOutOfLimits, fmt::format("{}: {:g}", word, trigger))
             : std::nullopt;
}

MaybeWrong wrong_measuring_mode(double mode) {
  return measuring_digit(mode) >= static_cast<int>(MeasuringMode::Continuous)
             ? wrong(AlarmId::NotImplemented, fmt::format("MEASA, mode {:.0f}", mode))
             : std::nullopt;
}

MaybeWrong wrong_second_trigger(double first, double second) {
  if (MaybeWrong wrong_one = wrong_trigger("MEASA", second)) {
    return wrong_one;
  }
  const bool same_edge = (first > 0.0) == (second > 0.0);
  return same_edge && first != second
             ? std::nullopt
             : wrong(AlarmId::NotImplemented, "MEASA: two edges of one probe, or different edges");
}

WrongValue measured_twice() {
  return {AlarmId::MeasuringTwice, ""};
}

WrongValue measured_circle() {
  return {AlarmId::NotImplemented, "MEAS on a circle"};
}

}  // namespace g31::sinumerik

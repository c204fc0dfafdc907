#pragma once

#include "interpreter/dialects/sinumerik/code/value_limits.h"

// What words take, whatever the channel's state: the same for a run and for who looks at words
// without running, as value_limits.h.  Each function says nullopt of what is right.

namespace g31::sinumerik {

using MaybeWrong = std::optional<WrongValue>;

/// Of a value that the range does not hold.
WrongValue out_of_range(std::string_view name, double value, const ValueRange& range);
/// FA[axis], ACC[axis] and the like.
MaybeWrong wrong_axis_setting(const AxisWordInfo& row, int axis, double value);

/// Words that count only with 0.
inline constexpr Address kOnlyZero[] = {Address::Conic, Address::NormalOffset};
/// Of another value.
WrongValue only_zero(Address address, double value);

/// SETAL
MaybeWrong wrong_alarm_number(double number);
/// Alarms of the measuring cycles that are shown and the program goes on: oversize, undersize,
/// permissible dimension difference exceeded (cycle manual 1486, 1512, 2492).
constexpr bool is_of_tolerance(int alarm) {
  return alarm >= 61304 && alarm <= 61306;
}
/// Alarms of programs that the operator clears before the program goes on: programs in use set them
/// and stop with M0 behind them.  62320 to 62322 are of the measuring cycles, which they end.
constexpr bool is_cleared_by_operator(int alarm) {
  const bool is_of_cycles = alarm >= 62320 && alarm <= 62322;
  return (alarm >= 62000 && alarm <= 62999 && !is_of_cycles) || (alarm >= 67000 && alarm <= 67999);
}
/// SETMS
MaybeWrong wrong_master_spindle(double number);
/// ID of a synchronised action
MaybeWrong wrong_action_number(double number);
/// LOCK, UNLOCK and RDISABLE stand behind DO alone.
constexpr bool belongs_to_action(ProcedureId id) {
  return id == ProcedureId::LOCK || id == ProcedureId::UNLOCK || id == ProcedureId::RDISABLE;
}
/// One of these that stands in a block of its own.
WrongValue outside_of_action(ProcedureId id);

/// T as a number.
MaybeWrong wrong_tool(double number);
/// D
MaybeWrong wrong_edge(double number);
/// DL
MaybeWrong wrong_additive(double number);
/// SF
MaybeWrong wrong_thread_angle(double degrees);

/// F of a motion.
constexpr bool is_feed(double feed) {
  return !(feed <= 0.0);
}
WrongValue no_feed();
/// G4
MaybeWrong wrong_dwell(double seconds);
/// Of an axis in the block of G4, which would neither move nor wait.
WrongValue axis_beside_dwell();
/// FP
MaybeWrong wrong_fixed_point(double number);

inline constexpr Address kCornerWords[] = {Address::Rounding, Address::Chamfer,
                                           Address::ChamferWidth};
MaybeWrong wrong_corner(double size);
/// Of a second one of them in a block.
WrongValue second_corner();

/// AP
MaybeWrong wrong_polar_angle(double degrees);
/// RP, mm
MaybeWrong wrong_polar_radius(double radius);
/// TURN
MaybeWrong wrong_turns(double turns);
/// AR
constexpr bool is_opening_angle(double degrees) {
  return degrees > 0.0 && degrees < 360.0;
}
WrongValue wrong_opening_angle(double degrees);

/// MEAS, MEAW, MEASA
MaybeWrong wrong_trigger(std::string_view word, double trigger);
/// The last digit of a mode of MEASA; the one before it is the measuring system.
// Source: NC programming, axial measuring.
enum class MeasuringMode {
  Off,             ///< breaks off
  AnyOrder,        ///< all triggers count from the start
  InOrder,         ///< each counts behind the one before it
  InOrderUnasked,  ///< the same; a probe that has switched at the start is no alarm
  Continuous,
};
constexpr int measuring_digit(double mode) {
  return static_cast<int>(mode) % 10;
}
/// @param mode  that wrong_measuring_mode() lets pass
constexpr MeasuringMode measuring_mode(double mode) {
  return static_cast<MeasuringMode>(measuring_digit(mode));
}
constexpr bool measures(double mode) {
  return measuring_digit(mode) != 0;
}
MaybeWrong wrong_measuring_mode(double mode);
/// A second trigger of MEASA.
MaybeWrong wrong_second_trigger(double first, double second);
/// Of two words that measure in a block.
WrongValue measured_twice();
/// Of one that measures beside another motion than G0 and G1.
WrongValue measured_circle();

}  // namespace g31::sinumerik

// M codes that are alike on most machines (ISO 6983-1).
#pragma once

namespace g31::runtime {

/// Whether an M code may turn the spindle, or stop it, beside M3, M4, M5 and M19: what codes of the
/// builder's do is not known; those of stops, tools, coolant, ends and gears do not.
constexpr bool may_turn_spindle(int code) {
  constexpr int kLastOfCoolant = 9;
  constexpr int kSubprogramEnd = 17;
  constexpr int kOrientation = 19;
  constexpr int kProgramEnd = 30;
  const bool is_gear = code >= 40 && code <= 45;
  return code > kLastOfCoolant && code != kSubprogramEnd && code != kOrientation &&
         code != kProgramEnd && !is_gear;
}

}  // namespace g31::runtime

#pragma once

#include <algorithm>
#include <cstdint>

namespace g31::fanuc {

inline constexpr std::int32_t kFirstLocal = 1;
inline constexpr std::int32_t kLocalCount = 33;    ///< #1..#33
inline constexpr std::int32_t kFirstCommon = 100;  ///< #100..#199, null after power on
inline constexpr std::int32_t kLastVolatile = 199;
inline constexpr std::int32_t kFirstPermanent = 500;  ///< #500..#999 kept when the power is off
inline constexpr std::int32_t kCommonEnd = 1000;

constexpr bool is_local(std::int32_t number) {
  return number >= kFirstLocal && number <= kLocalCount;
}

/// #100..#199 and #500..#999: what every control of the family has with its usual options.
constexpr bool is_common(std::int32_t number) {
  return (number >= kFirstCommon && number <= kLastVolatile) ||
         (number >= kFirstPermanent && number < kCommonEnd);
}

/// Whether a number behind # may name an element of a parameter of a Haas.
constexpr bool may_have_part(double number) {
  return number >= 30000.0 && number < 40000.0;
}

/// The number of a variable as a program writes it.  #30012.003 of a Haas, an element of a
/// parameter, counts as #30012003.
constexpr std::int32_t written_variable(double number) {
  constexpr double kLargest = 1e9;
  const double counted = std::min(number, kLargest);
  const bool has_part = may_have_part(counted) && counted != static_cast<std::int32_t>(counted);
  return static_cast<std::int32_t>((has_part ? counted * 1000.0 : counted) + 0.5);
}

}  // namespace g31::fanuc

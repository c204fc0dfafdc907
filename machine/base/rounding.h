#pragma once

#include <cmath>
#include <cstdint>

namespace g31 {

/// std::trunc without the call that it is on processors of the first x86-64 kind; the zero of a
/// small negative number has no sign.
inline double truncated(double value) {
  constexpr double kWhole = 4503599627370496.0;  // 2^52: no double beyond it has a fraction
  return std::abs(value) < kWhole ? static_cast<double>(static_cast<std::int64_t>(value)) : value;
}

/// std::round likewise: halves away from zero.
inline double rounded(double value) {
  const double whole = truncated(value);
  return std::abs(value - whole) < 0.5 ? whole : whole + std::copysign(1.0, value);
}

}  // namespace g31

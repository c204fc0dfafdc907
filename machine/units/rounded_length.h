#pragma once

#include <cmath>

namespace g31 {

/// A length, mm, to 1e-9 mm: what arithmetic adds to a length from a drawing does not show in
/// documents.  No zero is negative.
inline double rounded_length(double mm) {
  constexpr double kPerMm = 1e9;
  return std::round(mm * kPerMm) / kPerMm + 0.0;
}

/// A coordinate of a control, mm, inches or degrees, which counts increments: a whole number of
/// 1e-6 but for what binary sums have added to it as that number, any other one as it is.
inline double without_noise(double value) {
  constexpr double kPerUnit = 1e6;
  constexpr double kMostNoise = 1e-10;
  const double counted = std::round(value * kPerUnit) / kPerUnit + 0.0;
  return std::abs(counted - value) <= kMostNoise ? counted : value;
}

}  // namespace g31

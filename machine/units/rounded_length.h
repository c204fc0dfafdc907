#pragma once

#include <cmath>

namespace g31 {

/// A length, mm, to 1e-9 mm: what arithmetic adds to a length from a drawing does not show in
/// documents.  No zero is negative.
inline double rounded_length(double mm) {
  constexpr double kPerMm = 1e9;
  return std::round(mm * kPerMm) / kPerMm + 0.0;
}

}  // namespace g31

#pragma once

#include <cmath>
#include <numbers>

namespace g31::errors {

/// What comes back with every turn of an axis' screw, or with every period of its scale; mm or deg.
///
/// The lead of a ball screw wavers within each revolution (ISO 3408-3: V2pi, the travel variation
/// within 2 pi rad, is twice the amplitude of a sine), and a table behind an encoder on the screw
/// follows it.
struct CyclicErrorSetup {
  double amplitude = 0.0;  ///< >= 0
  double pitch = 10.0;     ///< > 0: way of one period
  double phase_deg = 0.0;  ///< at machine coordinate 0

  /// True minus encoder position.  @param q  encoder position, machine coordinate
  [[nodiscard]] double at(double q) const {
    if (amplitude == 0.0) {
      return 0.0;
    }
    const double phase_rad = phase_deg * std::numbers::pi / 180.0;
    return amplitude * std::sin(2.0 * std::numbers::pi * q / pitch + phase_rad);
  }
};

}  // namespace g31::errors

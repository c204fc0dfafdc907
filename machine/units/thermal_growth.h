#pragma once

namespace g31 {

/// Linear growth of a body that is not at the reference temperature.
struct ThermalGrowth {
  static constexpr double kReferenceTemperature = 20.0;  ///< deg C, of every drawing: ISO 1

  double expansion = 0.0;                      ///< um/(m K)
  double temperature = kReferenceTemperature;  ///< deg C

  /// By how much each unit of length is longer.
  [[nodiscard]] constexpr double per_unit() const {
    return 1e-6 * expansion * (temperature - kReferenceTemperature);
  }
};

}  // namespace g31

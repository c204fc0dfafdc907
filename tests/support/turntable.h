#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "machine/port/machine_port.h"

namespace g31::testing {

/// A table that turns about Z of the machine: the axes follow a point of it.
class Turntable final : public machine::AxisTransform {
 public:
  [[nodiscard]] std::optional<AxisPositions> axes_at(const AxisPositions& q_B) const override {
    return turned(q_B, -q_B[5]);
  }
  [[nodiscard]] AxisPositions base_at(const AxisPositions& q_M) const override {
    return turned(q_M, q_M[5]);
  }
  static AxisPositions turned(const AxisPositions& q, double deg) {
    const double angle = deg * std::numbers::pi / 180.0;
    AxisPositions result = q;
    result[0] = std::cos(angle) * q[0] - std::sin(angle) * q[1];
    result[1] = std::sin(angle) * q[0] + std::cos(angle) * q[1];
    return result;
  }
};

}  // namespace g31::testing

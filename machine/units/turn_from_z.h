#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "machine/units/point.h"

namespace g31 {

/// The shortest turn of +Z into a direction, to rounding; straight down, half a turn about X.
///
/// In place of Eigen's FromTwoVectors, which has its compiler spend seconds on a singular value
/// decomposition, and nowhere near straight down.
/// @pre along is not zero
inline Eigen::Quaterniond turn_from_z(const Point& along) {
  const Point to = along.normalized();
  if (to.z() >= 0.0) {
    const double twice_w = std::sqrt(2.0 * (1.0 + to.z()));
    const double inverse = 1.0 / twice_w;
    return {0.5 * twice_w, -to.y() * inverse, to.x() * inverse, 0.0};
  }
  const double across = std::hypot(to.x(), to.y());
  if (across == 0.0) {
    return {0.0, 1.0, 0.0, 0.0};
  }
  // 1 + z would lose its digits: it is across^2 / (1 - z).
  const double twice_sine = std::sqrt(2.0 * (1.0 - to.z()));
  const double share = 0.5 * twice_sine / across;
  return {across / twice_sine, -to.y() * share, to.x() * share, 0.0};
}

}  // namespace g31

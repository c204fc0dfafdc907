#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "machine/units/point.h"

namespace g31 {

/// How many axes a machine may have here, in this order: X Y Z A B C.
inline constexpr std::size_t kAxisCount = 6;

/// The letters of the axes in storage order.
inline constexpr char kAxisLetters[kAxisCount + 1] = "XYZABC";

/// One number per axis: mm for X Y Z, degrees for A B C; written `q_M` for machine coordinates,
/// `q_W` for work coordinates.  Axes a machine does not have stay 0.
using AxisPositions = Eigen::Matrix<double, static_cast<int>(kAxisCount), 1>;

/// The three linear axes as a point: on a three-axis machine the spindle gauge point.
inline Point linear_axes(const AxisPositions& q) {
  return q.head<3>();
}

/// The storage index of an axis letter, or -1.
constexpr int axis_index(char letter) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (kAxisLetters[i] == letter) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace g31

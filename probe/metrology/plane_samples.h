#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

#include "machine/port/work_watch.h"

namespace g31::metrology {

/// A path in a plane as it was recorded: sample i at t[i] s and (x[i], y[i]) mm.
///
/// x and y are the first and second axis of the plane, so that counter-clockwise is from x to y.
/// All spans have the same length and hold finite numbers; t rises.
struct PlaneSamples {
  std::span<const double> t;
  std::span<const double> x;
  std::span<const double> y;
  machine::WorkWatch* watch = nullptr;  ///< may end long work on them, by an exception

  /// In each step of long work.
  void look() const {
    if (watch != nullptr) {
      watch->look();
    }
  }
  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Eigen::Vector2d at(std::size_t i) const { return {x[i], y[i]}; }
};

/// A circle in a plane, mm.
struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0.0;
};

/// A number found from measurements, and its standard uncertainty.
struct Estimate {
  double value = 0.0;
  double u = 0.0;
};

}  // namespace g31::metrology

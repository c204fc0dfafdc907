#pragma once

#include <array>
#include <optional>
#include <string>

#include "machine/port/machine_port.h"
#include "machine/sim/machine_setup.h"

namespace g31::machine {

/// The soft limits of all axes.  An axis that the machine does not have may not leave its start.
///
/// On a straight move every axis is furthest out at an end, so the end point alone decides.
class TravelLimits {
 public:
  explicit TravelLimits(const MachineSetup& setup);

  /// The limits of the axes that there are become others.
  void set(const AxisPositions& q_M_min, const AxisPositions& q_M_max);
  [[nodiscard]] const AxisPositions& lower() const { return min_; }
  [[nodiscard]] const AxisPositions& upper() const { return max_; }

  /// Whether a position lies within the travel of every axis; the limits themselves do.
  [[nodiscard]] bool contain(const AxisPositions& q_M) const {
    // The nearest limit of all axes at once: asked axis by axis it takes twice as long.
    return (q_M - min_).cwiseMin(max_ - q_M).minCoeff() >= 0.0;
  }

  /// Whether one axis may go so far from a place, both ways.
  [[nodiscard]] bool contain(int axis, double place, double reach) const {
    return place - reach >= min_[axis] && place + reach <= max_[axis];
  }

  /// The travel of an axis; nullopt: the machine does not have it.
  [[nodiscard]] std::optional<AxisTravel> of(int axis) const;

  /// Why a position is outside, for people: the first such axis in the order X Y Z A B C, the
  /// position asked for and the limit.  @param q_M  mm and deg, not contained
  [[nodiscard]] std::string violation(const AxisPositions& q_M) const;

  /// Of such a position: whether that is an axis which the machine does not have.
  [[nodiscard]] bool is_without_axis(const AxisPositions& q_M) const {
    return !present_.at(first_outside(q_M));
  }

 private:
  [[nodiscard]] std::size_t first_outside(const AxisPositions& q_M) const;

  AxisPositions min_;
  AxisPositions max_;
  std::array<bool, kAxisCount> present_;
};

}  // namespace g31::machine

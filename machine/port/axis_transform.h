#pragma once

#include <memory>
#include <optional>

#include "machine/units/axis_positions.h"

namespace g31::machine {

/// A kinematic transformation as a control carries it out while it moves: a straight line or an arc
/// of the program is one in base coordinates, and the axes follow from every point of it.
///
/// Base coordinates (B) are X Y Z of the tool tip in a system that the control chooses, mm, and the
/// rotary axes as they are, deg.
class AxisTransform {
 public:
  AxisTransform() = default;
  AxisTransform(const AxisTransform&) = delete;
  AxisTransform& operator=(const AxisTransform&) = delete;
  virtual ~AxisTransform() = default;

  /// Where the axes are for a place; rotary axes stay as they are.  nullopt: with the rotary axes
  /// there, the linear ones do not lead to the place.
  [[nodiscard]] virtual std::optional<AxisPositions> axes_at(const AxisPositions& q_B) const = 0;

  /// The way back.
  [[nodiscard]] virtual AxisPositions base_at(const AxisPositions& q_M) const = 0;
};

/// Moves that pass on keep theirs until they are travelled.  Null: the axes are moved as they are.
using AxisTransformPtr = std::shared_ptr<const AxisTransform>;

}  // namespace g31::machine

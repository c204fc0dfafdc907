#pragma once

#include "machine/units/axis_positions.h"

namespace g31::machine {

/// A straight line in the space of all axes, travelled by all of them together.
class StraightPath {
 public:
  /// @param q_M_from, q_M_to  mm and deg, machine coordinates; finite
  /// @param mm_per_degree     what a degree counts for in length(); see LinearMove
  StraightPath(const AxisPositions& q_M_from, const AxisPositions& q_M_to,
               double mm_per_degree = 0.0);

  /// Both ends, machine coordinates, exactly as given.
  [[nodiscard]] const AxisPositions& from() const { return q_M_from_; }
  [[nodiscard]] const AxisPositions& to() const { return q_M_to_; }
  [[nodiscard]] const AxisPositions& displacement() const { return displacement_; }

  /// Whether any axis has a way to go at all.
  [[nodiscard]] bool moves() const { return q_M_from_ != q_M_to_; }

  /// What a vector feed counts: mm over X Y Z where they move, degrees over A B C where only these
  /// do; or all of them, where a degree counts for some mm.  Linear ways below kLeastFeedLengthMm
  /// beside a turning axis are rounding, not a move.
  [[nodiscard]] double length() const { return length_; }

  /// The derivative of at() by the fraction, the same everywhere.
  [[nodiscard]] const AxisPositions& slope_at(double /*fraction*/) const { return displacement_; }

  /// The point at a fraction 0..1 of the path; from 1 on exactly the end.  Never outside the box
  /// between start and end; axes that do not move keep their exact coordinates.
  [[nodiscard]] AxisPositions at(double fraction) const;

 private:
  AxisPositions q_M_from_;
  AxisPositions q_M_to_;
  AxisPositions displacement_;
  double length_;
};

/// Far below the least increment of any control (1e-6 mm), far above the rounding of coordinates.
inline constexpr double kLeastFeedLengthMm = 1e-9;

}  // namespace g31::machine

#pragma once

#include <algorithm>

#include "machine/port/machine_port.h"
#include "machine/units/axis_positions.h"

namespace g31::machine {

/// The two corners of a box in the space of all axes.
struct AxisBox {
  AxisPositions q_M_min;
  AxisPositions q_M_max;
};

/// An arc in the plane of two linear axes; the other axes go along in proportion to the angle.
///
/// Where start and end are not equally far from the centre, the radius changes in proportion too.
class ArcPath {
 public:
  /// @param arc  the plane is two different axes of X Y Z; all numbers finite
  ArcPath(const AxisPositions& q_M_from, const ArcMove& arc);

  [[nodiscard]] const AxisPositions& from() const { return q_M_from_; }
  [[nodiscard]] const AxisPositions& to() const { return q_M_to_; }
  [[nodiscard]] const AxisPositions& displacement() const { return displacement_; }
  [[nodiscard]] int first_axis() const { return first_axis_; }
  [[nodiscard]] int second_axis() const { return second_axis_; }

  /// rad, counterclockwise positive.  A full circle where start and end are, in the plane, closer
  /// than kFullCircleGapMm.
  [[nodiscard]] double turned_rad() const { return turned_rad_; }

  /// mm, halfway along the arc.
  [[nodiscard]] double radius() const { return 0.5 * (radius_from_ + radius_to_); }

  /// mm, of the centre in the plane, in machine coordinates.
  [[nodiscard]] double centre_first() const { return centre_first_; }
  [[nodiscard]] double centre_second() const { return centre_second_; }
  /// mm: nowhere on the arc is the centre farther away.
  [[nodiscard]] double largest_radius() const { return std::max(radius_from_, radius_to_); }

  /// mm in the plane, what the feed counts: the helix axes come on top, as on a control.
  [[nodiscard]] double length() const { return length_; }

  /// The point at a fraction 0..1 of the arc; from 1 on exactly the end.
  [[nodiscard]] AxisPositions at(double fraction) const;

  /// The derivative of at() by the fraction.  @param fraction 0..1
  [[nodiscard]] AxisPositions slope_at(double fraction) const;

  /// What the arc covers on each axis: both ends and where it crosses an axis direction.  Those
  /// crossings are taken kFullCircleGapMm short, so that rounding never breaks a travel limit.
  [[nodiscard]] AxisBox bounds() const;

  /// mm: the second derivative of the linear axes by the fraction is nowhere longer.
  [[nodiscard]] double bend() const;

  /// Into how many equal chords to cut the arc so that none is further from it than kChordErrorMm;
  /// 4 at least, so that a tiny full circle goes somewhere, and kMostChords at most.
  [[nodiscard]] int chord_count() const;

 private:
  /// The direction from the centre to the start, turned.
  [[nodiscard]] Eigen::Vector2d turned(double angle_rad) const;

  AxisPositions q_M_from_;
  AxisPositions q_M_to_;
  AxisPositions displacement_;
  int first_axis_;
  int second_axis_;
  double centre_first_;
  double centre_second_;
  double radius_from_;
  double radius_to_;
  Eigen::Vector2d direction_from_;  // from the centre to the start, length 1
  Eigen::Vector2d direction_to_;
  double turned_rad_;
  double length_;
};

/// Far below the least increment of any control (1e-6 mm), far above the rounding of coordinates.
inline constexpr double kFullCircleGapMm = 1e-9;

inline constexpr double kChordErrorMm = 0.001;
inline constexpr int kMostChords = 10'000;

}  // namespace g31::machine

#pragma once

#include <array>

#include "machine/errors/error_table.h"
#include "machine/units/point.h"

namespace g31::errors {

/// The 21 errors of three linear axes, named as in ISO 230-1: E, the direction, the axis that
/// moves.
struct GeometricErrorSetup {
  /// By moving axis X Y Z, then by direction: X Y Z in mm (positioning and straightness), A B C in
  /// um/m (roll, pitch and yaw).  EAX is `along[0][3]`.
  std::array<std::array<ErrorTable, 6>, 3> along = {};

  double c0y = 0.0;  ///< EC0Y, um/m: Y against X, turned about Z
  double b0z = 0.0;  ///< EB0Z, um/m: Z against X, turned about Y
  double a0z = 0.0;  ///< EA0Z, um/m: Z against Y, turned about X

  /// The axes in the order in which they follow each other from the part to the tool.
  std::array<int, 3> part_to_tool = {0, 1, 2};
};

/// How far the tool really is from where the scales say, relative to the part.
///
/// The errors of an axis are those of the spindle's gauge point while that axis moves alone and the
/// others stand at 0.  Its angular errors turn everything between it and the tool tip: the
/// positions of the axes that follow it towards the tool, and the tool.  First order: products of
/// two errors (1e-9 of the way) are left out.
class GeometricErrors {
 public:
  explicit GeometricErrors(const GeometricErrorSetup& setup);

  /// True minus indicated position of the tool tip, mm, machine frame.
  /// @param p_M    X Y Z as the scales indicate them, mm
  /// @param arm_M  the tip from the gauge point as the tool is turned, mm
  [[nodiscard]] Point at(const Point& p_M, const Point& arm_M) const;
  /// How far the angular errors turn what the axes carry there, rad.  @param p_M  as above
  [[nodiscard]] Point turn_at(const Point& p_M) const;

  [[nodiscard]] bool are_zero() const;

 private:
  GeometricErrorSetup setup_;
};

}  // namespace g31::errors

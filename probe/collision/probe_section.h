#pragma once

#include <string>

#include "machine/units/point.h"

namespace g31::probe {

/// One rigid piece of a probe: a cylinder or truncated cone about the vertical through the ball
/// centre, mm, grown by `rounding` on all sides.  Without rounding its ends are flat; a capsule is
/// a line (radii 0) with rounding.
struct ProbeSection {
  std::string name;       ///< "stem": for people
  double z_bottom = 0.0;  ///< above the ball centre
  double z_top = 0.0;     ///< >= z_bottom
  double radius_bottom = 0.0;
  double radius_top = 0.0;
  double rounding = 0.0;  ///< >= 0
};

/// The point of the section, with the ball centre at 0 and without rounding, that lies furthest in
/// a direction.
/// @param direction  of any length
Point furthest_of(const ProbeSection& section, const Point& direction);

/// The point of the section, with the ball centre at 0 and without rounding, nearest to p; p itself
/// inside.
Point nearest_of(const ProbeSection& section, const Point& p);

}  // namespace g31::probe

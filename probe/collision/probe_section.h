#pragma once

#include <string>

#include <Eigen/Geometry>

#include "machine/units/point.h"

namespace g31::probe {

/// One rigid piece of a probe: a cylinder or truncated cone about an axis, mm, grown by `rounding`
/// on all sides.  Without rounding its ends are flat; a capsule is a line (radii 0) with rounding.
///
/// Its own frame has the axis as Z.  As a rule that is the vertical through the main ball's centre.
struct ProbeSection {
  std::string name;       ///< "stem": for people
  double z_bottom = 0.0;  ///< above the origin of its own frame
  double z_top = 0.0;     ///< >= z_bottom
  double radius_bottom = 0.0;
  double radius_top = 0.0;
  double rounding = 0.0;  ///< >= 0
  /// Where its own frame is: from the main ball's centre, at spindle angle 0.
  Point p_S = Point::Zero();
  Eigen::Quaterniond turn_S = Eigen::Quaterniond::Identity();
};

/// How far the section reaches from the main ball's centre, mm.
double reach_of(const ProbeSection& section);

/// Where a section is: its own frame in that of the machine (of the part, where a table turns).
struct SectionPlace {
  Point p_M = Point::Zero();  ///< mm
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};

/// The point of the section, in its own frame and without rounding, that lies furthest in a
/// direction.
/// @param direction  of any length
Point furthest_of(const ProbeSection& section, const Point& direction);

/// The point of the section, in its own frame and without rounding, nearest to p; p itself inside.
Point nearest_of(const ProbeSection& section, const Point& p);

}  // namespace g31::probe

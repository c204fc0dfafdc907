#pragma once

#include <vector>

#include "machine/units/units.h"
#include "probe/tooling/convex_shape.h"
#include "probe/tooling/tool_setup.h"

namespace g31::probe {

/// The teeth of a tool that turns, each as if its plane were that of X.
struct TeethProfiles {
  std::vector<Blade> of_teeth;  ///< in the order of the teeth; empty: there are none
  Blade outline;                ///< of the widest and longest of them together
};

/// A tool as convex pieces in the frame of the gauge point: Z along its axis, the tool below, mm.
struct ToolShape {
  std::vector<ConvexShape> still;     ///< as it stands at spindle angle 0: blades, or what is round
  std::vector<ConvexShape> envelope;  ///< what it takes up while it turns
  std::vector<ConvexShape> bodies;    ///< chuck and shank
  TeethProfiles profiles;
  std::vector<ConvexShape> edges;  ///< of an insert, thin rods all around, for meshes
  Point p_T_tip = Point::Zero();   ///< lowest point on the axis, of an insert its theoretical tip
  double reach_mm = 0.0;           ///< no point of it is farther from the tip
};

/// The pieces of a tool.  Cutting edges are idealised: a tooth is a flat blade from the axis out,
/// its lower edge rises towards the axis by kDishDeg; the core that teeth stand on is a cylinder;
/// an insert is the ball of its tip radius and, where its angle is given, the thin plate between
/// its two edges.
/// @pre a tool that is no probe
ToolShape shape_of(const ToolSetup& tool);

/// The round ones of the pieces, told from the tip, as meshes are asked about them.
std::vector<ProbeSection> round_sections_of(const std::vector<ConvexShape>& pieces,
                                            const Point& p_T_tip);

/// How high the cone of a drill is at a radius, mm; of other tools 0.
double cone_height(const ToolSetup& tool, double radius);

/// A tooth at its angle.
Blade blade_of(const Tooth& tooth, const ToolSetup& tool);

/// The same, its plane that of X.
Blade profile_of(const Tooth& tooth, const ToolSetup& tool);

/// @pre it has teeth
TeethProfiles profiles_of(const ToolSetup& tool);

/// The widest and longest of the teeth together.  @pre it has teeth
Tooth outline_of(const ToolSetup& tool);

inline constexpr double kRadPerDeg = in_rad(deg(1.0));

/// How much the lower edges of teeth rise towards the axis: so it is their corner that touches.
inline constexpr double kDishDeg = 2.0;

}  // namespace g31::probe

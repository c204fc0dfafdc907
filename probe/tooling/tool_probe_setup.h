#pragma once

#include <array>
#include <string>
#include <string_view>

#include "machine/units/point.h"

namespace g31::probe {

enum class ToolProbeShape {
  Cube,   ///< a plate with flat sides
  Disc,   ///< a round plate, its axis upright
  Laser,  ///< a beam of light, as long as its first size says
};

struct ToolProbeShapeName {
  ToolProbeShape shape;
  std::string_view name;
};

/// What set-up sheets and documents call the shapes.
inline constexpr std::array<ToolProbeShapeName, 3> kToolProbeShapeNames = {{
    {ToolProbeShape::Cube, "cube"},
    {ToolProbeShape::Disc, "disc"},
    {ToolProbeShape::Laser, "laser"},
}};

enum class ToolProbeSide {
  Bed,    ///< stands, however tables turn
  Table,  ///< goes along with the part
};

/// One `[[tool_probe]]` of a set-up sheet: what measures tools.  Lengths in mm.
struct ToolProbeSetup {
  std::string name = "tool probe";
  ToolProbeShape shape = ToolProbeShape::Cube;
  /// Cube: along X, Y and Z.  Disc: diameter and thickness, Z.  Laser: length of the beam along X,
  /// its diameter.  The last ones are 0 where a shape has fewer.
  std::array<double, 3> size_mm = {25.0, 25.0, 25.0};
  /// Machine coordinates of the centre of the upper face, of a laser of the middle of the beam.
  Point p_M_at = Point::Zero();
  Point rotate_deg = Point::Zero();  ///< about X, then Y, then Z of the machine
  ToolProbeSide side = ToolProbeSide::Bed;
  int input = 2;                  ///< measuring input that it is wired to
  double delay_s = 0.0;           ///< >= 0, from the trigger to the signal
  double repeatability_mm = 0.0;  ///< standard deviation of the trigger point along the move
  double pre_travel_mm = 0.0;     ///< >= 0, along the normal until the signal
  /// How far the plate gives way until it breaks, along the normal; of a laser nothing.
  double deflection_limit_mm = 5.0;  ///< > 0
  double filter_s = 0.0;  ///< >= 0, of a laser: how much later the signal comes, drips sorted out
};

/// How large the box around it is that lies along its own axes, mm; of a beam without height.
inline Point extent_mm(const ToolProbeSetup& setup) {
  const auto& [first, second, third] = setup.size_mm;
  switch (setup.shape) {
    case ToolProbeShape::Cube:
      return {first, second, third};
    case ToolProbeShape::Disc:
      return {first, first, second};
    case ToolProbeShape::Laser:
      break;
  }
  return {first, second, 0.0};
}

}  // namespace g31::probe

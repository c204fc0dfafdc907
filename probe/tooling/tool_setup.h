#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "machine/units/point.h"
#include "probe/collision/probe_section.h"

namespace g31::probe {

/// What a tool is, as far as its shape goes.
enum class ToolKind {
  Mill,         ///< its lower end is flat
  BallMill,     ///< its lower end is half a ball of its diameter
  BullMill,     ///< its lower edge is rounded
  Drill,        ///< its lower end is a cone
  Turning,      ///< an insert, which does not turn
  Calibration,  ///< a cylinder, ground: what tool probes are calibrated with
  Probe,        ///< the touch probe of the sheet
};

struct ToolKindName {
  ToolKind kind;
  std::string_view name;
};

/// What set-up sheets and documents call the kinds.
inline constexpr std::array<ToolKindName, 7> kToolKindNames = {{
    {ToolKind::Mill, "mill"},
    {ToolKind::BallMill, "ball_mill"},
    {ToolKind::BullMill, "bull_mill"},
    {ToolKind::Drill, "drill"},
    {ToolKind::Turning, "turning"},
    {ToolKind::Calibration, "calibration"},
    {ToolKind::Probe, "probe"},
}};

/// One cutting edge of a tool that turns.
struct Tooth {
  double angle_deg = 0.0;  ///< from +X towards +Y at spindle angle 0
  double radius_mm = 0.0;  ///< > 0
  double length_mm = 0.0;  ///< gauge line to its lowest point
};

/// The insert of a turning tool.
struct Insert {
  /// L1 (X, as a radius), L2 (Z), L3 (Y): tool reference point less theoretical tip, mm.
  std::array<double, 3> lengths_mm = {};
  double tip_radius_mm = 0.0;  ///< >= 0
  int edge_position = 3;       ///< 1 to 9 as SINUMERIK counts: 3 cuts towards -X and -Z
  double angle_deg = 0.0;      ///< 0..180, between its two edges; 0: there is the tip alone
  /// From the tip along the middle between the edges, from +Z towards +X; nullopt: as the edge
  /// position has it, through the middle of the tip radius.
  std::optional<double> orientation_deg = {};
  double edge_length_mm = 10.0;  ///< > 0, of each edge, from the tip radius on
};

/// A tool as it truly is: one `[[tool]]` of a set-up sheet.  Lengths in mm.
struct ToolSetup {
  int number = 0;  ///< > 0: what T calls
  ToolKind kind = ToolKind::Mill;
  double length_mm = 0.0;            ///< gauge line to the lowest point, along -Z of the machine
  double diameter_mm = 0.0;          ///< > 0, but for turning tools and the probe
  double corner_radius_mm = 0.0;     ///< >= 0, of a bull mill and its teeth
  double cutting_length_mm = 0.0;    ///< of its edges, from the lowest point; 0: to the gauge line
  double core_diameter_mm = 0.0;     ///< what the teeth stand on; 0: they reach the axis
  double tip_angle_deg = 118.0;      ///< 0..180, of a drill, the whole cone
  std::vector<Tooth> teeth;          ///< none: a body of revolution
  Insert insert;                     ///< of a turning tool
  std::vector<ProbeSection> bodies;  ///< chuck and shank, from the lowest point: touch nothing
};

}  // namespace g31::probe

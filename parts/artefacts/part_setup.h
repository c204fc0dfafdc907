#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "machine/units/point.h"
#include "machine/units/thermal_growth.h"

namespace g31::parts {

/// A shape error that is known: rows of place and deviation out of the material, mm, places rising.
/// Straight between the places, constant outside them.
using ShapeProfile = std::vector<std::array<double, 2>>;

/// What carries a part, where that is no axis.
inline constexpr std::string_view kTableMount = "table";
inline constexpr std::string_view kBedMount = "bed";

/// One `[[part]]` of the set-up sheet.  Either `file` (an absolute or resolved path to a mesh) or
/// `shape` (a parametric artefact with its `sizes`) is given, never both.
struct PartSetup {
  std::string name;
  std::string file;
  double step_sagitta_mm = 1e-3;   ///< > 0: how fine a STEP file becomes a mesh
  std::string unit;                ///< of a file: a name of mesh_units.def; empty: not said
  double scale = 1.0;              ///< > 0: factor of all lengths of a file
  bool is_closed = true;           ///< of a file: meant to be the surface of solids
  bool is_fixture = false;         ///< a clamp or vice, which nothing may touch
  std::string mount{kTableMount};  ///< what carries it: also kBedMount or the letter of an axis
  std::string shape;               ///< "ring", ...; the table of shapes is artefacts/shapes.def
  std::map<std::string, double> sizes;  ///< mm; the names a shape takes stand in its row
  ShapeProfile profile;                 ///< of shapes that take one
  Point p_M_at = Point::Zero();         ///< machine coordinates of the part's origin
  Point rotate_deg = Point::Zero();     ///< about X, then Y, then Z (fixed axes)
  ThermalGrowth growth;                 ///< from the part's origin on
};

}  // namespace g31::parts

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include "machine/units/axis_positions.h"

namespace g31::machine {

/// Where a rotary axis is when all axes stand at 0.
struct RotaryLine {
  Point p_M_centre = Point::Zero();  ///< mm, any point of the line
  Point axis_M = Point::UnitZ();     ///< its direction, of any length > 0

  bool operator==(const RotaryLine&) const = default;
};

/// Which axes carry the part and which the tool: what a machine is, or what its control takes it
/// for.
struct AxisChainSetup {
  std::string table_side;         ///< axis letters from the part to the bed: "CAX"
  std::string tool_side = "XYZ";  ///< from the bed to the tool
  std::array<RotaryLine, kRotaryAxisCount> rotary = {  ///< A B C
      RotaryLine{Point::Zero(), Point::UnitX()}, RotaryLine{Point::Zero(), Point::UnitY()},
      RotaryLine{Point::Zero(), Point::UnitZ()}};

  bool operator==(const AxisChainSetup&) const = default;
};

/// Where the tool is for the part.
struct ToolPlace {
  /// The linear axes of a machine without rotary axes that has its tip at the same place of the
  /// part; the rotary ones as they are.
  AxisPositions q;
  /// How the tool is turned against the part.
  Eigen::Quaterniond tilt = Eigen::Quaterniond::Identity();
  /// By which angular errors turn it, and what it carries, about its tip, rad.
  Point lean_rad = Point::Zero();
};

/// The forward transform of a machine: where the tool is for the part.
///
/// A position of an axis counts the motion of the tool relative to the part, as ISO 841 has it: a
/// positive angle turns the tool right-handed about the line, so a table turns its part the other
/// way.  Linear axes go along X Y Z of the machine.  The frame of the part is that of the machine
/// when all rotary axes stand at 0.
class AxisChain {
 public:
  /// @param p_T_tip  mm, the tool tip from the gauge point; where the chain has no rotary axis it
  ///                 does not matter
  AxisChain(const AxisChainSetup& setup, const Point& p_T_tip);

  /// @param p_T_tip  mm, the tool tip from now on, from the gauge point
  void take_tool(const Point& p_T_tip) { p_T_tip_ = p_T_tip; }

  [[nodiscard]] bool has_rotary_axes() const { return has_rotary_axes_; }

  /// Where the tool is for the part.  With all rotary axes at 0 nothing changes, bit for bit.
  [[nodiscard]] ToolPlace for_part(const AxisPositions& q_M) const;

  /// The inverse: the position whose tool tip is at a place of the part.  nullopt: as the rotary
  /// axes stand, the linear ones do not lead everywhere.
  ///
  /// Accuracy: for_part of it is the place within kChainErrorMm for coordinates within 1000 mm.
  /// @param p_P_tip    mm, frame of the part
  /// @param q_M_turned  rotary axes as they stand; the linear ones do not count
  [[nodiscard]] std::optional<AxisPositions> axes_for(const Point& p_P_tip,
                                                      const AxisPositions& q_M_turned) const;

  /// The linear axes whose tool tip comes nearest to a place of the part, those that are not in the
  /// chain at 0; where the tip gets there, the same as axes_for.
  [[nodiscard]] AxisPositions axes_near(const Point& p_P_tip,
                                        const AxisPositions& q_M_turned) const;

  /// The tool tip from the gauge point as the axes that carry the tool turn it, mm, along the axes
  /// of the machine.
  [[nodiscard]] Point tool_vector(const AxisPositions& q_M) const;

  /// Whether the frame of the part is turned in that of the machine, or the tool against it.
  [[nodiscard]] bool is_turned(const AxisPositions& q_M) const;

  /// From the frame of the machine to that of the part.
  [[nodiscard]] Eigen::Isometry3d part_from_machine(const AxisPositions& q_M) const;

  /// The same from the frame of a link: what that many axes lie between the part and.  Link 0 is
  /// the part itself, the last one holds the tool; all frames are one when all axes stand at 0.
  [[nodiscard]] Eigen::Isometry3d part_from_link(std::size_t link, const AxisPositions& q_M) const;

 private:
  /// How the place of the tip depends on the linear axes: in straight lines.
  struct LinearMotion {
    Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();  ///< a column each; zero: not in it
    Point p_P_origin = Point::Zero();                      ///< the tip with all of them at 0
  };

  [[nodiscard]] LinearMotion linear_motion(const AxisPositions& q_M_turned) const;
  /// The motion of a rotary axis.
  [[nodiscard]] Eigen::Isometry3d joint(char axis, const AxisPositions& q_M) const;
  [[nodiscard]] Eigen::Isometry3d along(std::string_view axes, const AxisPositions& q_M) const;

  AxisChainSetup setup_;
  Point p_T_tip_;
  bool has_rotary_axes_;
};

/// The link of a chain that an axis carries: on the table's side what is between it and the part.
/// nullopt: the axis is not in the chain.
std::optional<std::size_t> link_on_axis(const AxisChainSetup& setup, char axis);

/// What neither table nor tool moves.
inline std::size_t link_of_bed(const AxisChainSetup& setup) {
  return setup.table_side.size();
}

/// Five times the worst error of a place through axes_for and for_part, seen over 12 000 positions
/// of six machines; tests/machine/kinematics_test.cc holds it.
inline constexpr double kChainErrorMm = 2.5e-12;

}  // namespace g31::machine

#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "machine/kinematics/orientation.h"

namespace g31::machine {

/// The vectors of a machine with one or two rotary axes, as the data of a tool carrier name them
/// ($TC_CARR1 and on), all axes at 0, mm along the axes of the machine.
///
///   Tool   I3 tool adapter to axis 2, I2 axis 2 to axis 1, I1 closes
///   Part   I2 machine to axis 1, I3 axis 1 to axis 2, I4 closes
///   Mixed  I2 tool adapter to axis 1, I1 closes; I3 machine to axis 2, I4 closes
///
/// A positive angle turns what the axis carries right-handed about V, tool or part: of a head V is
/// the axis' direction, of a table the opposite.
struct KinematicVectors {
  KinematicType type = KinematicType::Tool;
  std::array<int, 2> axes = {-1, -1};  ///< storage indices of axes 1 and 2; -1: none
  Point i1 = Point::Zero();
  Point i2 = Point::Zero();
  Point i3 = Point::Zero();
  Point i4 = Point::Zero();
  Point v1 = Point::Zero();  ///< of any length; no length: the axis does not turn
  Point v2 = Point::Zero();

  /// The vector from the tip to where the machine takes the tool to be held, as the head turns it.
  /// @param length  from the tip to the adapter with the axes at 0; (0, 0, L) of an upright tool
  [[nodiscard]] Point tool_length(const Point& length, const std::array<double, 2>& deg) const;
  /// The rotation of the tool.
  [[nodiscard]] Eigen::Matrix3d tool_turn(const std::array<double, 2>& deg) const;
  /// How the part has moved: from where a point is with the axes at 0 to where it is, along the
  /// axes of the machine.
  [[nodiscard]] Eigen::Isometry3d part_motion(const std::array<double, 2>& deg) const;

  bool operator==(const KinematicVectors&) const = default;
};

/// The vectors of a chain, closed.  Two tables or two heads are named by the feet of the common
/// perpendicular of their lines, one of each by the points that the chain has.  nullopt: no rotary
/// axis, more than two, two that are parallel, or a linear axis that a rotary one carries further
/// out than vectors can say.
std::optional<KinematicVectors> vectors_of(const AxisChainSetup& chain);

/// A chain and what its vectors leave open.
struct VectorChain {
  AxisChainSetup chain;
  Point tool_shift = Point::Zero();  ///< added to the tool's length whatever the head does, mm
  Point part_shift = Point::Zero();  ///< added to places of the part, mm
  /// Of rotary axes: the positions at which their angles are 0.
  AxisPositions q_M_basic = AxisPositions::Zero();

  bool operator==(const VectorChain&) const = default;
};

/// The chain that has these vectors.
/// @param linear  the sides that the linear axes move, as in the chain of the machine
VectorChain chain_of(const KinematicVectors& vectors, const AxisChainSetup& linear);

}  // namespace g31::machine

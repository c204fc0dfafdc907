#pragma once

#include <optional>

#include "machine/kinematics/axis_chain.h"
#include "machine/kinematics/kinematic_vectors.h"

namespace g31::machine {

/// What a control does about rotary axes between the places of a program and the axes.
enum class TransformationKind {
  None,         ///< a place is one of the machine, whatever the rotary axes do
  ToolCarrier,  ///< the tool's length goes along with the axes that turn the tool (TCARR)
  FiveAxis,     ///< a place is one of the part, and the tip stays there (TRAORI, G43.4)
};

/// From places of the tool tip to axis positions and back, by what a *control* takes the machine
/// for.  What the machine makes of these positions is AxisChain::for_part of what it is: with equal
/// chains and tools FiveAxis brings the tip exactly there.
class Transformation {
 public:
  /// @param p_T_tip  mm, the tool tip from the gauge point, as the control believes it
  Transformation(TransformationKind kind, const AxisChainSetup& believed, const Point& p_T_tip)
      : kind_(kind), chain_(believed, p_T_tip), p_T_tip_(p_T_tip) {}

  /// FiveAxis, by vectors that may be open.
  Transformation(const VectorChain& believed, const Point& p_T_tip)
      : kind_(TransformationKind::FiveAxis),
        chain_(believed.chain, p_T_tip),
        p_T_tip_(p_T_tip),
        tool_shift_(believed.tool_shift),
        part_shift_(believed.part_shift),
        q_M_basic_(believed.q_M_basic) {}

  /// nullopt: as the rotary axes stand, the linear ones do not lead everywhere.
  /// @param p_tip       mm, frame of the machine, with FiveAxis of the part (work offset included)
  /// @param q_M_turned  rotary axes as they stand; the linear ones do not count
  [[nodiscard]] std::optional<AxisPositions> axes_for(const Point& p_tip,
                                                      const AxisPositions& q_M_turned) const;

  /// The inverse: the place of the tip, mm, as axes_for takes it.
  [[nodiscard]] Point tip_for(const AxisPositions& q_M) const;

 private:
  TransformationKind kind_;
  AxisChain chain_;
  Point p_T_tip_;
  Point tool_shift_ = Point::Zero();
  Point part_shift_ = Point::Zero();
  AxisPositions q_M_basic_ = AxisPositions::Zero();
};

}  // namespace g31::machine

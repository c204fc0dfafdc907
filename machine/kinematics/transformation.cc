#include "machine/kinematics/transformation.h"

namespace g31::machine {

std::optional<AxisPositions> Transformation::axes_for(const Point& p_tip,
                                                      const AxisPositions& q_M_turned) const {
  if (kind_ == TransformationKind::FiveAxis) {
    std::optional<AxisPositions> q_M =
        chain_.axes_for(p_tip + part_shift_, q_M_turned - q_M_basic_);
    if (q_M) {
      q_M->head<kLinearAxisCount>() += tool_shift_;
      q_M->tail<kRotaryAxisCount>() = rotary_axes(q_M_turned);
    }
    return q_M;
  }
  AxisPositions q_M = q_M_turned;
  q_M.head<kLinearAxisCount>() =
      p_tip -
      (kind_ == TransformationKind::ToolCarrier ? chain_.tool_vector(q_M_turned) : p_T_tip_);
  return q_M;
}

Point Transformation::tip_for(const AxisPositions& q_M) const {
  if (kind_ == TransformationKind::FiveAxis) {
    AxisPositions q_M_closed = q_M - q_M_basic_;
    q_M_closed.head<kLinearAxisCount>() -= tool_shift_;
    return linear_axes(chain_.for_part(q_M_closed).q) + p_T_tip_ - part_shift_;
  }
  return linear_axes(q_M) +
         (kind_ == TransformationKind::ToolCarrier ? chain_.tool_vector(q_M) : p_T_tip_);
}

}  // namespace g31::machine

#include "machine/kinematics/transformation.h"

namespace g31::machine {

std::optional<AxisPositions> Transformation::axes_for(const Point& p_tip,
                                                      const AxisPositions& q_M_turned) const {
  if (kind_ == TransformationKind::FiveAxis) {
    return chain_.axes_for(p_tip, q_M_turned);
  }
  AxisPositions q_M = q_M_turned;
  q_M.head<kLinearAxisCount>() =
      p_tip -
      (kind_ == TransformationKind::ToolCarrier ? chain_.tool_vector(q_M_turned) : p_T_tip_);
  return q_M;
}

}  // namespace g31::machine

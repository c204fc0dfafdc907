#include "interpreter/path/tip_transform.h"

namespace g31::path {

std::optional<AxisPositions> TipTransform::axes_at(const AxisPositions& q_B) const {
  return chain_.axes_for(part_from_base_ * linear_axes(q_B), q_B);
}

AxisPositions TipTransform::base_at(const AxisPositions& q_M) const {
  AxisPositions q_B = q_M;
  const Point p_P_tip = linear_axes(chain_.for_part(q_M).q) + p_T_tip_;
  q_B.head<kLinearAxisCount>() = base_from_part_ * p_P_tip;
  return q_B;
}

Point TipTransform::turned(const AxisPositions& q_M, const Point& vector_T) const {
  return base_from_part_.linear() * (chain_.for_part(q_M).tilt * vector_T);
}

}  // namespace g31::path

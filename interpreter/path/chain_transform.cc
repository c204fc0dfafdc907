#include "interpreter/path/chain_transform.h"

namespace g31::path {

std::optional<AxisPositions> ChainTransform::axes_at(const AxisPositions& q_B) const {
  return by_.axes_for(part_from_base_ * linear_axes(q_B), q_B);
}

AxisPositions ChainTransform::base_at(const AxisPositions& q_M) const {
  AxisPositions q_B = q_M;
  q_B.head<kLinearAxisCount>() = part_from_base_.transpose() * by_.tip_for(q_M);
  return q_B;
}

}  // namespace g31::path

#include "tools/picture/on_part.h"

#include <Eigen/Geometry>

namespace g31::picture {

SurfacePlace on_part(const machine::AxisChain& chain, const AxisPositions& q_M,
                     const SurfacePlace& place_M) {
  if (!chain.has_rotary_axes() || !chain.is_turned(q_M)) {
    return place_M;
  }
  const Eigen::Isometry3d part_from_machine = chain.part_from_machine(q_M);
  return {part_from_machine * place_M.p, part_from_machine.linear() * place_M.n};
}

}  // namespace g31::picture

#include "machine/kinematics/axis_chain.h"

#include <algorithm>

#include "machine/units/units.h"

namespace g31::machine {
namespace {

constexpr int kLinearAxes = 3;

bool is_rotary(char axis) {
  return axis_index(axis) >= kLinearAxes;
}

}  // namespace

AxisChain::AxisChain(const AxisChainSetup& setup, const Point& p_T_tip)
    : setup_(setup),
      p_T_tip_(p_T_tip),
      has_rotary_axes_(std::ranges::any_of(setup.table_side + setup.tool_side, is_rotary)) {
  for (RotaryLine& line : setup_.rotary) {
    line.axis_M.normalize();
  }
}

ToolPlace AxisChain::for_part(const AxisPositions& q_M) const {
  ToolPlace place{q_M};
  if (is_turned(q_M)) {
    const Eigen::Isometry3d table = along(setup_.table_side, q_M);
    const Eigen::Isometry3d tool = along(setup_.tool_side, q_M);
    place.q.head<kLinearAxes>() = table * (tool * p_T_tip_) - p_T_tip_;
    place.tilt = Eigen::Quaterniond((table * tool).linear());
  }
  return place;
}

bool AxisChain::is_turned(const AxisPositions& q_M) const {
  return has_rotary_axes_ && !q_M.tail<3>().isZero(0.0);
}

Eigen::Isometry3d AxisChain::joint(char axis, const AxisPositions& q_M) const {
  const int index = axis_index(axis);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (!is_rotary(axis)) {
    motion.translation()[index] = q_M[index];
    return motion;
  }
  const RotaryLine& line = setup_.rotary.at(static_cast<std::size_t>(index - kLinearAxes));
  motion.translate(line.p_M_centre);
  motion.rotate(Eigen::AngleAxisd(in_rad(deg(q_M[index])), line.axis_M));
  motion.translate(-line.p_M_centre);
  return motion;
}

Eigen::Isometry3d AxisChain::along(const std::string& axes, const AxisPositions& q_M) const {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (const char axis : axes) {
    motion = motion * joint(axis, q_M);
  }
  return motion;
}

Eigen::Isometry3d AxisChain::part_from_machine(const AxisPositions& q_M) const {
  // Linear axes under the table count as motion of the tool in the machine's frame.
  Point carried_M = Point::Zero();
  for (const char axis : setup_.table_side) {
    if (!is_rotary(axis)) {
      carried_M[axis_index(axis)] = q_M[axis_index(axis)];
    }
  }
  Eigen::Isometry3d motion = along(setup_.table_side, q_M);
  motion.translate(-carried_M);
  return motion;
}

}  // namespace g31::machine

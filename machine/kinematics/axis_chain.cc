#include "machine/kinematics/axis_chain.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "machine/units/units.h"

namespace g31::machine {
namespace {

/// Linear axes whose directions span less than this leave a direction out; three at right angles
/// span 1.
constexpr double kLeastSpan = 1e-9;

bool is_rotary(char axis) {
  return is_rotary_axis(axis_index(axis));
}

/// The steps of the axes that come nearest to a way, by least squares.  An axis that adds no
/// direction to those before it stands still.
/// @param directions  a column of length 1 for each axis, 0 for one that moves nothing
Point nearest_steps(const Eigen::Matrix3d& directions, const Point& way) {
  Eigen::Matrix3d square = directions;  // square to the columns before them
  for (Eigen::Index i = 0; i < square.cols(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      square.col(i) -= square.col(j).dot(square.col(i)) * square.col(j);
    }
    const double length = square.col(i).norm();
    square.col(i) *= length > kLeastSpan ? 1.0 / length : 0.0;
  }
  Point steps = Point::Zero();
  for (Eigen::Index i = square.cols() - 1; i >= 0; --i) {
    const double advance = square.col(i).dot(directions.col(i));
    steps[i] = advance > 0.0 ? square.col(i).dot(way - directions * steps) / advance : 0.0;
  }
  return steps;
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
    place.q.head<kLinearAxisCount>() = table * (tool * p_T_tip_) - p_T_tip_;
    place.tilt = Eigen::Quaterniond(Eigen::Matrix3d(table.linear() * tool.linear()));
  }
  return place;
}

std::optional<AxisPositions> AxisChain::axes_for(const Point& p_P_tip,
                                                 const AxisPositions& q_M_turned) const {
  AxisPositions q_M = q_M_turned;
  q_M.head<kLinearAxisCount>().setZero();
  if (!is_turned(q_M)) {
    q_M.head<kLinearAxisCount>() = p_P_tip - p_T_tip_;
    return q_M;
  }
  const auto [directions, p_P_origin] = linear_motion(q_M);
  if (std::abs(directions.determinant()) < kLeastSpan) {
    return std::nullopt;
  }
  q_M.head<kLinearAxisCount>() = directions.inverse() * (p_P_tip - p_P_origin);
  return q_M;
}

AxisPositions AxisChain::axes_near(const Point& p_P_tip, const AxisPositions& q_M_turned) const {
  if (auto q_M = axes_for(p_P_tip, q_M_turned)) {
    return *std::move(q_M);
  }
  AxisPositions q_M = q_M_turned;
  const auto [directions, p_P_origin] = linear_motion(q_M_turned);
  q_M.head<kLinearAxisCount>() = nearest_steps(directions, p_P_tip - p_P_origin);
  return q_M;
}

AxisChain::LinearMotion AxisChain::linear_motion(const AxisPositions& q_M_turned) const {
  AxisPositions q_M = q_M_turned;
  q_M.head<kLinearAxisCount>().setZero();
  LinearMotion linear;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (const char axis : setup_.table_side + setup_.tool_side) {
    if (is_rotary(axis)) {
      motion = motion * joint(axis, q_M);
    } else {
      linear.directions.col(axis_index(axis)) = motion.linear().col(axis_index(axis));
    }
  }
  linear.p_P_origin = motion * p_T_tip_;
  return linear;
}

Point AxisChain::tool_vector(const AxisPositions& q_M) const {
  AxisPositions q_M_rotary = q_M;
  q_M_rotary.head<kLinearAxisCount>().setZero();
  return is_turned(q_M) ? Point(along(setup_.tool_side, q_M_rotary) * p_T_tip_) : p_T_tip_;
}

bool AxisChain::is_turned(const AxisPositions& q_M) const {
  return has_rotary_axes_ && !rotary_axes(q_M).isZero(0.0);
}

Eigen::Isometry3d AxisChain::joint(char axis, const AxisPositions& q_M) const {
  const int index = axis_index(axis);
  const RotaryLine& line = setup_.rotary.at(static_cast<std::size_t>(index - kLinearAxisCount));
  const Eigen::AngleAxisd turn(in_rad(deg(q_M[index])), line.axis_M);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = turn.toRotationMatrix();
  motion.translation() = line.p_M_centre - motion.linear() * line.p_M_centre;
  return motion;
}

Eigen::Isometry3d AxisChain::along(std::string_view axes, const AxisPositions& q_M) const {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  for (const char axis : axes) {
    const int index = axis_index(axis);
    if (!is_rotary(axis)) {
      motion.translation() += motion.linear().col(index) * q_M[index];
    } else if (q_M[index] != 0.0) {
      motion = motion * joint(axis, q_M);
    }
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

Eigen::Isometry3d AxisChain::part_from_link(std::size_t link, const AxisPositions& q_M) const {
  return along((setup_.table_side + setup_.tool_side).substr(0, link), q_M);
}

std::optional<std::size_t> link_on_axis(const AxisChainSetup& setup, char axis) {
  const std::size_t below = setup.table_side.find(axis);
  if (below != std::string::npos) {
    return below;
  }
  const std::size_t above = setup.tool_side.find(axis);
  return above == std::string::npos ? std::nullopt
                                    : std::optional(setup.table_side.size() + above + 1);
}

}  // namespace g31::machine

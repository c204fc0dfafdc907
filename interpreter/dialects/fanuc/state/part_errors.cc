#include "interpreter/dialects/fanuc/state/part_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "machine/base/contract.h"
#include "machine/kinematics/plane_rotation.h"

namespace g31::fanuc {
namespace {

/// How the table has turned the frame of the machine against the part.
Eigen::Matrix3d turned(const machine::AxisChainSetup& believed, const AxisPositions& q_M) {
  return machine::AxisChain(believed, Point::Zero()).part_from_machine(q_M).linear();
}

/// The table's axes from the bed on, at the positions of an error.
AxisPositions positions_of(const SettingError& error, const machine::AxisChainSetup& believed) {
  AxisPositions q_M = AxisPositions::Zero();
  const std::string& side = believed.table_side;
  std::size_t next = 0;
  for (auto letter = side.rbegin(); letter != side.rend(); ++letter) {
    const int axis = axis_index(*letter);
    if (is_rotary_axis(axis) && next < error.table_deg.size()) {
      q_M[axis] = error.table_deg.at(next++);
    }
  }
  return q_M;
}

Eigen::Matrix3d turn_of(const Point& deg) {
  return machine::about_fixed_axes({{{0, deg.x()}, {1, deg.y()}, {2, deg.z()}}});
}

/// The way back, deg; of errors, which are small.
Point angles_of(const Eigen::Matrix3d& turn) {
  return (180.0 / std::numbers::pi) * Point(std::atan2(turn(2, 1), turn(2, 2)),
                                            std::asin(std::clamp(-turn(2, 0), -1.0, 1.0)),
                                            std::atan2(turn(1, 0), turn(0, 0)));
}

/// The same error, found with the table at 0.
SettingError at_zero(const SettingError& error, const machine::AxisChainSetup& believed) {
  const Eigen::Matrix3d turn = turned(believed, positions_of(error, believed));
  return {turn * error.shift, angles_of(turn * turn_of(error.turn_deg) * turn.transpose()), {0, 0}};
}

/// How the groups of G54.2 turn with their rotary axes.
Eigen::Matrix3d turn_by(const PartErrors::TableGroups& groups, const AxisPositions& q_M) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  for (const TableGroup& group : groups) {
    if (group.rotary >= 0) {
      const Point along = Point::Unit(group.first).cross(Point::Unit(group.second));
      turn = machine::turn_about(along, q_M[group.rotary]) * turn;
    }
  }
  return turn;
}

}  // namespace

const AxisPositions& PartErrors::table_offset(int n) const {
  G31_EXPECTS(n >= 1 && n <= kTableOffsets);
  return table_offsets_.at(static_cast<std::size_t>(n));
}

void PartErrors::set_table_offset(int n, const AxisPositions& q_offset) {
  G31_EXPECTS(n >= 1 && n <= kTableOffsets);
  table_offsets_.at(static_cast<std::size_t>(n)) = q_offset;
}

const SettingError& PartErrors::setting_error(int n) const {
  G31_EXPECTS(n >= 0 && n <= kSettingErrors);
  return setting_errors_.at(static_cast<std::size_t>(n));
}

void PartErrors::set_setting_error(int n, const SettingError& error) {
  G31_EXPECTS(n >= 0 && n <= kSettingErrors);
  setting_errors_.at(static_cast<std::size_t>(n)) = error;
}

Point PartErrors::offset_by_groups(const AxisPositions& q_M) const {
  if (table_offset_selected_ == 0) {
    return Point::Zero();
  }
  const AxisPositions& q_offset = table_offset(table_offset_selected_);
  return turn_by(table_groups_, q_M) *
         (turn_by(table_groups_, q_offset).transpose() * linear_axes(q_offset));
}

Eigen::Isometry3d PartErrors::on_table(const machine::AxisChainSetup& believed,
                                       bool with_offset) const {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  if (table_offset_selected_ != 0 && with_offset) {
    const AxisPositions& q_offset = table_offset(table_offset_selected_);
    moved.translate(turned(believed, q_offset) * linear_axes(q_offset));
  }
  if (setting_error_selected_ != 0) {
    const SettingError common = at_zero(setting_error(0), believed);
    const SettingError own = at_zero(setting_error(setting_error_selected_), believed);
    moved.translate(common.shift + own.shift);
    moved.rotate(turn_of(common.turn_deg + own.turn_deg));
  }
  return moved;
}

}  // namespace g31::fanuc

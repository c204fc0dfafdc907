#include "interpreter/dialects/fanuc/state/coordinates.h"

#include <tuple>
#include <utility>

#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

const AxisPositions& no_shift() {
  static const AxisPositions kZero = AxisPositions::Zero();
  return kZero;
}

/// The rotary axes alone.
AxisPositions turned(const AxisPositions& q) {
  AxisPositions q_rotary = q;
  q_rotary.head<kLinearAxisCount>().setZero();
  return q_rotary;
}

}  // namespace

const AxisPositions& Coordinates::system(int which) const {
  G31_EXPECTS(which >= 0 && which <= kSystems + kAdditional);
  if (which <= kSystems) {
    return systems_[static_cast<std::size_t>(which)];
  }
  const auto found = additional_.find(which);
  return found != additional_.end() ? found->second : no_shift();
}

void Coordinates::set_system(int which, int axis, double value) {
  G31_EXPECTS(which >= 0 && which <= kSystems + kAdditional);
  if (which <= kSystems) {
    systems_[static_cast<std::size_t>(which)][axis] = value;
  } else {
    additional_.try_emplace(which, AxisPositions::Zero()).first->second[axis] = value;
  }
  refresh();
}

void Coordinates::select(int which) {
  selected_ = which;
  refresh();
}

const AxisPositions& Coordinates::local_shift() const {
  const auto found = local_shifts_.find(locally_shifted());
  return found != local_shifts_.end() ? found->second : no_shift();
}

void Coordinates::set_local_shift(int axis, double value) {
  local_shifts_.try_emplace(locally_shifted(), no_shift()).first->second[axis] = value;
  refresh();
}

void Coordinates::declare(int axis, double value) {
  G31_EXPECTS(tip_ == nullptr);
  q_L_unturned_.reset();
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  q_L_programmed_[axis] = value;
  declared_shift_ += q_W - transform_.apply(q_L_programmed_);
  // The local shift of the axis becomes part of the declared one: G92 ends G52 (MB-290).  Shifts of
  // single systems stay, for G92 shifts all systems alike.
  const auto of_all = local_shifts_.find(0);
  if (of_all != local_shifts_.end()) {
    declared_shift_[axis] += std::exchange(of_all->second[axis], 0.0);
  }
  take_shift();
}

bool Coordinates::set_tool_offset(const AxisPositions& offset) {
  const bool changes = offset != tool_offset_;
  if (changes) {
    tool_offset_ = offset;
    lead();
  }
  return changes;
}

void Coordinates::end_tool_offset(int axis) {
  tool_offset_[axis] = 0.0;
  lead();
}

void Coordinates::shift_tool_offset(const AxisPositions& offset) {
  if (tip_) {
    keep_axes([&] { tool_offset_ = offset; });
    return;
  }
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  q_L_programmed_ = transform_.undo(q_W + (tool_offset_ - offset));
  tool_offset_ = offset;
}

void Coordinates::clear_shifts(int axis) {
  for (auto& shift : local_shifts_) {
    shift.second[axis] = 0.0;
  }
  declared_shift_[axis] = 0.0;
  refresh();
}

void Coordinates::set_transform(const WorkTransform& transform) {
  q_L_unturned_.reset();
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  transform_ = transform;
  q_L_programmed_ = transform_.undo(q_W);
}

void Coordinates::set_kinematics(const machine::AxisChainSetup& believed,
                                 const Eigen::Isometry3d& tool_at_rest) {
  keep_axes([&] {
    believed_ = believed;
    tool_at_rest_ = tool_at_rest;
    table_ = machine::AxisChain(believed, Point::Zero());
    orientation_ = machine::OrientationAxes::of(believed);
  });
}

void Coordinates::set_part_errors(const PartErrors& errors, bool turns_tool) {
  keep_axes([&] {
    part_errors_ = errors;
    turns_tool_ = turns_tool && errors.has_setting_error();
  });
}

void Coordinates::shift_with_table(const AxisPositions& q_M) {
  table_shift_.setZero();
  refresh();
  const Point p_M_origin = linear_axes(shift_);
  table_shift_.head<kLinearAxisCount>() =
      table_.part_from_machine(turned(q_M)).inverse() * p_M_origin - p_M_origin;
  refresh();
}

void Coordinates::end_shift_with_table() {
  table_shift_.setZero();
  refresh();
}

void Coordinates::set_plane(const std::optional<Eigen::Isometry3d>& work_from_plane) {
  keep_axes([&] { work_from_plane_ = work_from_plane; });
}

void Coordinates::set_tip_system(TipSystem system) {
  keep_axes([&] { tip_system_ = system; });
}

AxisPositions Coordinates::tool_offset_at(const AxisPositions& q_M) const {
  if (!tip_) {
    return tool_offset_;
  }
  AxisPositions along = AxisPositions::Zero();
  Point vector = tip_->turned(q_M, tool_at_rest_.linear() * linear_axes(tool_offset_));
  if (tip_system_ == TipSystem::Workpiece) {
    vector = table_turn(q_M).transpose() * vector;
  }
  along.head<kLinearAxisCount>() = vector;
  return along;
}

Eigen::Matrix3d Coordinates::table_turn(const AxisPositions& q_M) const {
  return table_.part_from_machine(turned(q_M)).linear();
}

ToolInWork Coordinates::tool_in_work(const AxisPositions& q_M) const {
  const Point p_T_tip = tip_at_rest();
  const machine::ToolPlace place = machine::AxisChain(believed_, p_T_tip).for_part(q_M);
  return {linear_axes(place.q) + p_T_tip - linear_axes(shift_),
          place.tilt.toRotationMatrix() * tool_at_rest_.linear()};
}

void Coordinates::take_shift() {
  shift_ = system(0) + system(selected_) + local_shift() + declared_shift_ + table_shift_;
}

void Coordinates::refresh() {
  q_L_unturned_.reset();
  if (!is_plain_) {
    keep_axes([this] { take_shift(); });
    return;
  }
  const AxisPositions q_W = transform_.apply(q_L_programmed_);
  const AxisPositions before = shift_;
  take_shift();
  q_L_programmed_ = transform_.undo(q_W + (before - shift_));
}

template <typename Change>
void Coordinates::keep_axes(Change change) {
  const auto q_M = axes_at(to_path(q_L_programmed_));
  change();
  lead();
  if (q_M) {
    q_L_programmed_ = to_program(*q_M);
  }
}

void Coordinates::lead() {
  tip_.reset();
  const bool has_error = part_errors_.is_any_selected();
  const bool is_led = tip_system_ != TipSystem::None || work_from_plane_;
  // Where something leads the axes, the offset of G54.2 lies in the part.
  error_ = has_error ? part_errors_.on_table(believed_, is_led || !part_errors_.turns_by_groups())
                     : Eigen::Isometry3d::Identity();
  if (tip_system_ != TipSystem::None || work_from_plane_) {
    Eigen::Isometry3d part_from_base = Eigen::Isometry3d::Identity();
    part_from_base.translate(linear_axes(shift_));
    part_from_base = part_from_base * error_;
    if (tip_system_ == TipSystem::Workpiece) {
      part_from_base.translate(-linear_axes(shift_));
    } else {
      part_from_base = part_from_base * work_from_plane_.value_or(Eigen::Isometry3d::Identity());
    }
    tip_ = std::make_shared<path::TipTransform>(believed_, tip_at_rest(), part_from_base);
  }
  is_plain_ = !tip_ && !has_error;
  leader_ = tip_;
}

void Coordinates::turn_tool(AxisPositions& q_B, const Eigen::Matrix3d& turn) const {
  if (!turns_tool_ || tip_system_ == TipSystem::None || !orientation_) {
    return;
  }
  std::array<double, 2> from = {0.0, 0.0};
  for (std::size_t i = 0; i < orientation_->count(); ++i) {
    from.at(i) = q_B[orientation_->axes().at(i)];
  }
  const Point at_rest = tool_at_rest_.linear().col(2);
  const Point direction = turn * (orientation_->turn(from) * at_rest);
  const auto pair = machine::least_motion(orientation_->pairs_for(direction, at_rest), from, {}, 0);
  for (std::size_t i = 0; pair && i < orientation_->count(); ++i) {
    q_B[orientation_->axes().at(i)] = pair->deg.at(i);
  }
}

Point Coordinates::offset_by_groups(const AxisPositions& q_M) const {
  return part_errors_.turns_by_groups() ? part_errors_.offset_by_groups(q_M) : Point(Point::Zero());
}

AxisPositions Coordinates::led_path_of(const AxisPositions& q_W) const {
  AxisPositions q_B = q_W + shift_;
  if (!tip_) {
    // The work system does not turn: the errors of the part do, with the table.
    const Eigen::Matrix3d turn = table_turn(q_B);
    q_B.head<kLinearAxisCount>() = linear_axes(shift_) + offset_by_groups(q_B) +
                                   turn.transpose() * (error_ * (turn * linear_axes(q_W)));
    return q_B + tool_offset_;
  }
  q_B.head<kLinearAxisCount>() =
      tip_system_ == TipSystem::Workpiece
          ? Point(table_.part_from_machine(turned(q_B)) * linear_axes(q_B))
          : linear_axes(q_W);
  turn_tool(q_B, error_.linear());
  return q_B;
}

AxisPositions Coordinates::led_work_of(const AxisPositions& q_B) const {
  if (!tip_) {
    AxisPositions q_W = q_B - shift_ - tool_offset_;
    q_W.head<kLinearAxisCount>() -= offset_by_groups(q_B);
    const Eigen::Matrix3d turn = table_turn(q_B);
    q_W.head<kLinearAxisCount>() =
        turn.transpose() * (error_.inverse() * (turn * linear_axes(q_W)));
    return q_W;
  }
  AxisPositions q_W = q_B;
  turn_tool(q_W, error_.linear().transpose());
  q_W.head<kLinearAxisCount>() =
      tip_system_ == TipSystem::Workpiece
          ? Point(table_.part_from_machine(turned(q_W)).inverse() * linear_axes(q_B))
          : Point(linear_axes(q_B) + linear_axes(shift_));
  return q_W - shift_;
}

bool operator==(const Coordinates& a, const Coordinates& b) {
  const auto told = [](const Coordinates& one) {
    return std::tie(one.systems_, one.additional_, one.selected_, one.shifts_each_system_,
                    one.local_shifts_, one.declared_shift_, one.table_shift_, one.tool_offset_,
                    one.shift_, one.transform_, one.q_L_programmed_, one.q_L_unturned_,
                    one.believed_, one.part_errors_, one.error_.matrix(),
                    one.tool_at_rest_.matrix(), one.turns_tool_, one.is_plain_, one.tip_system_);
  };
  const auto is_same_plane = [&] {
    return !a.work_from_plane_ || a.work_from_plane_->matrix() == b.work_from_plane_->matrix();
  };
  return told(a) == told(b) && a.work_from_plane_.has_value() == b.work_from_plane_.has_value() &&
         is_same_plane();
}

}  // namespace g31::fanuc

#include "probe/sensor/bed_view.h"

#include <utility>

#include "machine/base/contract.h"

namespace g31::probe {

void BedView::take_tool(const Point& p_T_tip) {
  p_T_tip_ = p_T_tip;
  if (chain_) {
    chain_->take_tool(p_T_tip);
  }
}

std::optional<Eigen::Isometry3d> BedView::part_from_bed(const machine::Waypoint& at) const {
  if (!chain_ || !chain_->is_turned(at.q_M)) {
    return std::nullopt;
  }
  const Point p_P_tip = linear_axes(at.q_M) + p_T_tip_;
  // Linear axes count under the table alone, and such a machine has all three.
  return chain_->part_from_machine(chain_->axes_for(p_P_tip, at.q_M).value_or(at.q_M));
}

machine::Waypoint BedView::from_bed(const machine::Waypoint& at) const {
  const auto part_from_machine = part_from_bed(at);
  if (!part_from_machine) {
    return at;
  }
  const Eigen::Isometry3d machine_from_part = part_from_machine->inverse();
  machine::Waypoint seen = at;
  seen.q_M.head<kLinearAxisCount>() =
      machine_from_part * (linear_axes(at.q_M) + p_T_tip_) - p_T_tip_;
  seen.tilt = Eigen::Quaterniond(machine_from_part.linear()) * at.tilt;
  return seen;
}

std::vector<machine::Waypoint> BedView::from_bed(const machine::Way& way) const {
  std::vector<machine::Waypoint> points = machine::points_of(way);
  for (machine::Waypoint& point : points) {
    point = from_bed(point);
  }
  return points;
}

machine::Contact BedView::for_part(const machine::Contact& contact,
                                   const machine::Waypoint& at) const {
  const auto part_from_machine = part_from_bed(at);
  return part_from_machine
             ? machine::Contact{*part_from_machine * contact.p_M_point,
                                part_from_machine->linear() * contact.n_M, contact.part}
             : contact;
}

BedObstacles::BedObstacles(std::unique_ptr<machine::Surroundings> inner, machine::AxisChain chain)
    : inner_(std::move(inner)), bed_(std::move(chain)) {
  G31_EXPECTS(inner_ != nullptr);
}

std::optional<machine::SkipTrigger> BedObstacles::first_signal(const machine::Way& /*way*/,
                                                               const machine::Listening& /*to*/) {
  return std::nullopt;
}

std::optional<machine::Obstacle> BedObstacles::first_obstacle(const machine::Way& way,
                                                              machine::Travel travel) {
  const auto p_T_tip = inner_->tool_extent().p_T_tip;
  if (!p_T_tip) {
    return std::nullopt;  // what could meet them is not in place
  }
  bed_.take_tool(*p_T_tip);
  const std::vector<machine::Waypoint> points = bed_.from_bed(way);
  auto obstacle = inner_->first_obstacle(machine::Way(points), travel);
  if (obstacle) {
    obstacle->contact = bed_.for_part(obstacle->contact, machine::points_of(way).front());
  }
  return obstacle;
}

bool BedObstacles::signals_at(const machine::Waypoint& /*at*/, int /*input*/) const {
  return false;
}

std::optional<machine::SensorState> BedObstacles::sensor_state(int /*input*/) const {
  return std::nullopt;
}

machine::ToolExtent BedObstacles::tool_extent() const {
  return inner_->tool_extent();
}

void BedObstacles::take(const machine::MachineEvent& event) {
  inner_->take(event);
}

void BedObstacles::time_is(double now_s) {
  inner_->time_is(now_s);
}

}  // namespace g31::probe

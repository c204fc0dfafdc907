#include "probe/sensor/cutting_tool.h"

#include <utility>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "probe/tooling/spindle.h"

namespace g31::probe {
namespace {

void add_to(ToolObstacles::Group& group, const ProbedPart& part, const CollisionMesh& mesh) {
  group.meshes.push_back(mesh);
  group.names.push_back(part.name);
}

}  // namespace

CentreWay way_of_tip(const Point& p_T_tip, const machine::Sweep& sweep) {
  CentreWay way{linear_axes(sweep.q_M_from) + p_T_tip, linear_axes(sweep.q_M_to) + p_T_tip};
  way.turn_from = sweep.tilt_from;
  way.turn_to = sweep.tilt_to;
  return way;
}

void ToolObstacles::add(const ProbedPart& part, const CollisionMesh& mesh) {
  if (part.role == Role::SensingTarget) {
    return;
  }
  add_to(of_holders, part, mesh);
  if (encounter_of(Role::Cutter, part.role, machine::Travel::Feed) == Encounter::Obstacle) {
    add_to(of_cutters, part, mesh);
  }
}

CuttingTool::CuttingTool(std::shared_ptr<const ToolObstacles> obstacles,
                         std::shared_ptr<const ToolRack> rack)
    : obstacles_(std::move(obstacles)), rack_(std::move(rack)) {
  G31_EXPECTS(obstacles_ != nullptr && rack_ != nullptr);
}

std::optional<machine::SkipTrigger> CuttingTool::first_signal(const machine::Way& /*way*/,
                                                              const machine::Listening& /*to*/) {
  return std::nullopt;
}

bool CuttingTool::signals_at(const machine::Waypoint& /*at*/,
                             const machine::Listening& /*to*/) const {
  return false;
}

std::optional<machine::SensorState> CuttingTool::sensor_state(int /*input*/) const {
  return std::nullopt;
}

machine::ToolExtent CuttingTool::tool_extent() const {
  return held_ != nullptr ? machine::ToolExtent{held_->shape.p_T_tip, 0.0, held_->shape.reach_mm}
                          : machine::ToolExtent();
}

void CuttingTool::take(const machine::MachineEvent& event) {
  const auto* const change = std::get_if<machine::ToolChange>(&event);
  if (change == nullptr || change->spindle != kToolSpindle) {
    return;
  }
  held_ = rack_->called(change->tool);
  cutter_.clear();
  holder_.clear();
  if (held_ != nullptr) {
    const ToolShape& shape = held_->shape;
    cutter_ = round_sections_of(shape.envelope, shape.p_T_tip);
    const Sections edges = round_sections_of(shape.edges, shape.p_T_tip);
    cutter_.insert(cutter_.end(), edges.begin(), edges.end());
    for (ProbeSection& section : cutter_) {
      section.name = fmt::format("tool T{}", held_->setup.number);
    }
    holder_ = round_sections_of(shape.bodies, shape.p_T_tip);
  }
}

std::optional<machine::Obstacle> CuttingTool::first_obstacle(const machine::Way& way,
                                                             machine::Travel /*travel*/) {
  if (held_ == nullptr || obstacles_->of_holders.meshes.empty()) {
    return std::nullopt;
  }
  const std::vector<machine::Waypoint> points = machine::points_of(way);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!machine::differ(points[i - 1], points[i])) {
      continue;
    }
    const machine::Sweep sweep = machine::sweep_between(points[i - 1], points[i]);
    auto obstacle = touch_of(cutter_, obstacles_->of_cutters, sweep);
    auto of_holder = touch_of(holder_, obstacles_->of_holders, sweep);
    if (of_holder && (!obstacle || of_holder->fraction < obstacle->fraction)) {
      obstacle = std::move(of_holder);
    }
    if (obstacle) {
      obstacle->fraction = machine::fraction_between(points[i - 1], points[i], obstacle->fraction);
      return obstacle;
    }
  }
  return std::nullopt;
}

std::optional<machine::Obstacle> CuttingTool::touch_of(const Sections& sections,
                                                       const ToolObstacles::Group& others,
                                                       const machine::Sweep& sweep) const {
  if (sections.empty() || others.meshes.empty()) {
    return std::nullopt;
  }
  const auto met = first_touch(sections, others.meshes, way_of_tip(held_->shape.p_T_tip, sweep));
  if (!met) {
    return std::nullopt;
  }
  const std::string& part = others.names[met->part];
  return machine::Obstacle{met->touch.fraction,
                           fmt::format("{} touches {}", met->section, part),
                           {met->touch.p_M_point, met->touch.n_M, part}};
}

}  // namespace g31::probe

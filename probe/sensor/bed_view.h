#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "machine/kinematics/axis_chain.h"
#include "machine/port/surroundings.h"

namespace g31::probe {

/// What stands on the bed while tables turn: the world is asked in the frame of the part, and this
/// tells where the tool is in that of the machine.
class BedView {
 public:
  BedView() = default;
  /// @param chain  nullopt: no table turns, the two frames are one
  explicit BedView(std::optional<machine::AxisChain> chain) : chain_(std::move(chain)) {}

  /// @param p_T_tip  mm, what the tool turns about, from the gauge point
  void take_tool(const Point& p_T_tip);

  [[nodiscard]] machine::Waypoint from_bed(const machine::Waypoint& at) const;
  [[nodiscard]] std::vector<machine::Waypoint> from_bed(const machine::Way& way) const;
  /// A contact that was found so, back in the frame of the part.
  /// @param at  on the way, as the world was asked about it
  [[nodiscard]] machine::Contact for_part(const machine::Contact& contact,
                                          const machine::Waypoint& at) const;

 private:
  [[nodiscard]] std::optional<Eigen::Isometry3d> part_from_bed(const machine::Waypoint& at) const;

  std::optional<machine::AxisChain> chain_;
  Point p_T_tip_ = Point::Zero();
};

/// Obstacles that stand on the bed of a machine whose tables turn, as a set of the world: what
/// another set meets that knows nothing of tables.  It gives no signal of its own.
class BedObstacles final : public machine::Surroundings {
 public:
  /// @param inner  among what stands on the bed alone; not null
  BedObstacles(std::unique_ptr<machine::Surroundings> inner, machine::AxisChain chain);

  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;
  [[nodiscard]] bool signals_at(const machine::Waypoint& at, int input) const override;
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int input) const override;
  [[nodiscard]] machine::ToolExtent tool_extent() const override;
  void take(const machine::MachineEvent& event) override;
  void time_is(double now_s) override;

 private:
  std::unique_ptr<machine::Surroundings> inner_;
  BedView bed_;
};

}  // namespace g31::probe

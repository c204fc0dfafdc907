#pragma once

#include <memory>
#include <vector>

#include "machine/port/surroundings.h"
#include "probe/sensor/displacement_sensors.h"

namespace g31::probe {

/// Who says which tool the spindle holds.
enum class Tools {
  Fixed,     ///< nobody: what is there stays there, whatever tools programs call
  Changing,  ///< programs: a tool that is none of the sets here is what the control believes
};

/// Several sets of bodies in one world: probes, tool probes, each of them surroundings of its own;
/// and sensors that touch nothing.
///
/// All are asked, and what comes first counts.  A set whose sensor is not in place keeps silent.  A
/// tool that no set here is cuts: it touches nothing that is here but parts (encounters.def).
class World final : public machine::Surroundings {
 public:
  using Sets = std::vector<std::unique_ptr<machine::Surroundings>>;

  /// @param sets  none null
  /// @param sensors  null: none
  World(Sets sets, Tools tools, std::unique_ptr<DisplacementSensors> sensors = nullptr);

  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;
  [[nodiscard]] bool signals_at(const machine::Waypoint& at,
                                const machine::Listening& to) const override;
  [[nodiscard]] std::string stands_inside(const machine::Waypoint& at) const override;

  /// Of several on one input, that of the first in place, else of the first.
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int input) const override;

  [[nodiscard]] std::optional<Point> displacement_sensor(int input) const override;
  [[nodiscard]] double displacement(const machine::Waypoint& at, int input) const override;

  /// The tip of the set that is in place, else of the tool that was called.
  [[nodiscard]] machine::ToolExtent tool_extent() const override;

  void take(const machine::MachineEvent& event) override;
  void time_is(double now_s) override;

 private:
  Sets sets_;
  Tools tools_;
  std::unique_ptr<DisplacementSensors> sensors_;
  machine::Tool called_;
  double now_s_ = 0.0;
};

}  // namespace g31::probe

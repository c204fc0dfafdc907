#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "machine/port/surroundings.h"

namespace g31::probe {

/// The probe of a second spindle, which the same axes carry beside the first one, as a set of the
/// world: it is asked about its own way, which the first tool's way leads.
class SecondProbe final : public machine::Surroundings {
 public:
  struct Place {
    Point p_T_beside = Point::Zero();  ///< mm, from the first spindle to the second
    Point p_T_first = Point::Zero();   ///< tip of the first probe, from its gauge point
    Point p_T_second = Point::Zero();  ///< of the second one, from its own
  };
  /// @param inner  the probe in its own spindle; not null
  SecondProbe(std::unique_ptr<machine::Surroundings> inner, const Place& place);

  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;
  [[nodiscard]] bool signals_at(const machine::Waypoint& at,
                                const machine::Listening& to) const override;
  [[nodiscard]] std::string stands_inside(const machine::Waypoint& at) const override;
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int input) const override;
  /// The machine leads the tip of the first one; this one reaches as far as its spindle is.
  [[nodiscard]] machine::ToolExtent tool_extent() const override;
  void take(const machine::MachineEvent& event) override;
  void time_is(double now_s) override;

 private:
  /// Where the axes would stand with the second probe in the first spindle's place.
  [[nodiscard]] machine::Waypoint own(const machine::Waypoint& at) const;
  /// Asks about a way along which the own one is led.
  template <typename Ask>
  auto along(const machine::Way& way, Ask ask) const;

  std::unique_ptr<machine::Surroundings> inner_;
  Place place_;
};

}  // namespace g31::probe

#pragma once

#include <optional>
#include <vector>

#include "machine/port/surroundings.h"

namespace g31::testing {

/// A world that knows straight pieces only: of a way it is asked about one after the other.  As it
/// stands it holds nothing.
class WorldOfPieces : public machine::Surroundings {
 public:
  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override {
    if (to.edge == machine::SignalEdge::Falling) {
      return machine::SkipTrigger{0.0, true, 0.0, std::nullopt};
    }
    return first_of<machine::SkipTrigger>(
        way, [this](const machine::Sweep& sweep) { return trigger_on(sweep); });
  }

  /// What a skip move breaks, it does not tell.
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override {
    if (travel == machine::Travel::Skip) {
      return std::nullopt;
    }
    return first_of<machine::Obstacle>(
        way, [this](const machine::Sweep& sweep) { return obstacle_on(sweep); });
  }

  [[nodiscard]] bool signals_at(const machine::Waypoint& /*at*/,
                                const machine::Listening& /*to*/) const override {
    return false;
  }
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int /*input*/) const override {
    return machine::SensorState();
  }
  [[nodiscard]] machine::ToolExtent tool_extent() const override { return {}; }
  void take(const machine::MachineEvent& event) override { events_.push_back(event); }

  [[nodiscard]] const std::vector<machine::MachineEvent>& events() const { return events_; }

 protected:
  virtual std::optional<machine::SkipTrigger> trigger_on(const machine::Sweep& /*sweep*/) {
    return std::nullopt;
  }
  virtual std::optional<machine::Obstacle> obstacle_on(const machine::Sweep& /*sweep*/) {
    return std::nullopt;
  }

 private:
  template <typename Event, typename Question>
  static std::optional<Event> first_of(const machine::Way& way, const Question& question) {
    const std::vector<machine::Waypoint> points = machine::points_of(way);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const machine::Waypoint& from = points[i - 1];
      const machine::Waypoint& to = points[i];
      auto event = machine::differ(from, to) ? question(machine::sweep_between(from, to))
                                             : std::optional<Event>();
      if (event) {
        event->fraction = machine::fraction_between(from, to, event->fraction);
        return event;
      }
    }
    return std::nullopt;
  }

  std::vector<machine::MachineEvent> events_;
};

}  // namespace g31::testing

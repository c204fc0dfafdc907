#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "machine/port/machine_port.h"
#include "machine/port/surroundings.h"
#include "probe/sensor/probe_setup.h"

namespace g31::probe {

/// Skip signals from a list instead of a probe: for programs without parts, and for tests.
///
/// The n-th skip move takes the n-th signal of the list, whether it uses it or not; it rises when
/// the axis reaches its machine coordinate, however tables and heads are turned.  Ideal: no delay,
/// no random shift, nothing to collide with.
class ScriptedSignals final : public machine::Surroundings {
 public:
  /// @param signals  axis 0..5 each
  explicit ScriptedSignals(std::vector<SkipSignal> signals);

  /// No signal: the list is used up, the signal has no `at`, its axis does not move in this sweep
  /// or ends before `at`.  An axis that starts at `at` or beyond it in the direction of its motion:
  /// the signal is on at the start.
  /// With a falling edge the signal of the list goes off instead of on.  Whatever input a move
  /// listens to, the signal is that of the move.
  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;

  /// The signal that came last is there as long as its axis stays at its coordinate or beyond.
  [[nodiscard]] bool signals_at(const machine::Waypoint& at,
                                const machine::Listening& to) const override;

  /// Always nullopt.
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;

  /// Always ready.
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int /*input*/) const override {
    return machine::SensorState();
  }
  [[nodiscard]] machine::ToolExtent tool_extent() const override { return {}; }
  void take(const machine::MachineEvent& /*event*/) override {}

 private:
  /// What the last skip move made of the signal.
  struct Edge {
    int axis = 0;
    double at = 0.0;
    double direction = 1.0;  ///< of the axis
    machine::SignalEdge edge = machine::SignalEdge::Rising;

    [[nodiscard]] bool is_reached_at(double place) const { return direction * (place - at) >= 0.0; }
  };
  /// The fraction of a way whose axes do not go along with the tip; nullopt: on no point of it.
  static std::optional<double> where_reached(const Edge& edge,
                                             std::span<const machine::Waypoint> points,
                                             const machine::Listening& to);

  std::vector<SkipSignal> signals_;
  std::size_t used_ = 0;
  std::optional<Edge> last_;
};

}  // namespace g31::probe

#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "machine/base/contract.h"
#include "machine/port/surroundings.h"
#include "tests/support/world_of_pieces.h"

namespace g31::testing {

/// The signal of one skip move: it rises where one axis passes a coordinate.
struct ScriptedSignal {
  char axis = 'X';
  std::optional<double> at;  ///< machine coordinate; none, or not on the sweep: no signal
  double delay_s = 0.0;
  bool on_at_start = false;  ///< high before the move begins, whatever `at` says
  std::optional<machine::Contact> contact;
};

/// A world that answers from two scripts, in order, and writes down the sweeps it was asked about.
/// After a script's end there is no signal, and no obstacle.
class ScriptedSurroundings final : public WorldOfPieces {
 public:
  using Obstacles = std::vector<std::optional<machine::Obstacle>>;

  explicit ScriptedSurroundings(std::vector<ScriptedSignal> signals = {}, Obstacles obstacles = {})
      : signals_(std::move(signals)), obstacles_(std::move(obstacles)) {}

  /// The signals depend on the ends of a way only, the obstacles on each piece of it.
  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override {
    if (to.edge == machine::SignalEdge::Falling) {
      return WorldOfPieces::first_signal(way, to);
    }
    const std::vector<machine::Waypoint> points = machine::points_of(way);
    if (!machine::differ(points.front(), points.back())) {
      return std::nullopt;
    }
    auto trigger = trigger_on(machine::sweep_between(points.front(), points.back()));
    if (trigger) {
      trigger->fraction = machine::fraction_at_share(points, trigger->fraction);
    }
    return trigger;
  }

  /// The sweeps of the skip moves and of the ordinary moves so far.
  [[nodiscard]] const std::vector<machine::Sweep>& skip_sweeps() const { return skip_sweeps_; }
  [[nodiscard]] const std::vector<machine::Sweep>& move_sweeps() const { return move_sweeps_; }

 private:
  std::optional<machine::SkipTrigger> trigger_on(const machine::Sweep& sweep) override {
    skip_sweeps_.push_back(sweep);
    if (skip_sweeps_.size() > signals_.size()) {
      return std::nullopt;
    }
    return trigger(signals_[skip_sweeps_.size() - 1], sweep);
  }

  std::optional<machine::Obstacle> obstacle_on(const machine::Sweep& sweep) override {
    move_sweeps_.push_back(sweep);
    if (move_sweeps_.size() > obstacles_.size()) {
      return std::nullopt;
    }
    return obstacles_[move_sweeps_.size() - 1];
  }

  static std::optional<machine::SkipTrigger> trigger(const ScriptedSignal& signal,
                                                     const machine::Sweep& sweep) {
    if (signal.on_at_start) {
      return machine::SkipTrigger{0.0, true, signal.delay_s, signal.contact};
    }
    const int axis = axis_index(signal.axis);
    G31_EXPECTS(axis >= 0);
    const double way = sweep.q_M_to[axis] - sweep.q_M_from[axis];
    if (!signal.at || way == 0.0) {
      return std::nullopt;
    }
    const double fraction = (*signal.at - sweep.q_M_from[axis]) / way;
    if (fraction < 0.0 || fraction > 1.0) {
      return std::nullopt;
    }
    return machine::SkipTrigger{fraction, false, signal.delay_s, signal.contact};
  }

  std::vector<ScriptedSignal> signals_;
  Obstacles obstacles_;
  std::vector<machine::Sweep> skip_sweeps_;
  std::vector<machine::Sweep> move_sweeps_;
};

}  // namespace g31::testing

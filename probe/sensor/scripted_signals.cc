#include "probe/sensor/scripted_signals.h"

#include <utility>

#include "machine/base/contract.h"

namespace g31::probe {

ScriptedSignals::ScriptedSignals(std::vector<SkipSignal> signals) : signals_(std::move(signals)) {
  for (const SkipSignal& signal : signals_) {
    G31_EXPECTS(signal.axis >= 0 && signal.axis < static_cast<int>(kAxisCount));
  }
}

std::optional<machine::SkipTrigger> ScriptedSignals::first_signal(const machine::Way& way,
                                                                  const machine::Listening& to) {
  const std::vector<machine::Waypoint> points = machine::points_of(way);
  if (!machine::differ(points.front(), points.back())) {
    return std::nullopt;
  }
  auto trigger = next({points.front().q_M, points.back().q_M}, to.edge);
  if (trigger) {
    trigger->fraction = machine::fraction_at_share(points, trigger->fraction);
  }
  return trigger;
}

bool ScriptedSignals::signals_at(const machine::Waypoint& at, int /*input*/) const {
  if (!last_) {
    return false;
  }
  const bool is_beyond = last_->direction * (at.q_M[last_->axis] - last_->at) >= 0.0;
  return is_beyond == (last_->edge == machine::SignalEdge::Rising);
}

std::optional<machine::SkipTrigger> ScriptedSignals::next(const machine::Sweep& sweep,
                                                          machine::SignalEdge edge) {
  if (used_ == signals_.size()) {
    return std::nullopt;
  }
  const SkipSignal& signal = signals_[used_++];
  const double from = sweep.q_M_from[signal.axis];
  const double to = sweep.q_M_to[signal.axis];
  if (!signal.at || from == to) {
    return std::nullopt;
  }
  const double way = to - from;
  const double way_to_signal = *signal.at - from;
  machine::SkipTrigger trigger;
  if (way_to_signal == 0.0 || (way_to_signal < 0.0) != (way < 0.0)) {
    trigger.on_at_start = true;
    return trigger;
  }
  if (way_to_signal / way > 1.0) {
    return std::nullopt;
  }
  trigger.fraction = way_to_signal / way;
  last_ = {signal.axis, *signal.at, way > 0.0 ? 1.0 : -1.0, edge};
  return trigger;
}

std::optional<machine::Obstacle> ScriptedSignals::first_obstacle(const machine::Way& /*way*/,
                                                                 machine::Travel /*travel*/) {
  return std::nullopt;
}

}  // namespace g31::probe

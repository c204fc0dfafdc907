#include "probe/sensor/scripted_signals.h"

#include <algorithm>
#include <numeric>
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
  if (!machine::differ(points.front(), points.back()) || used_ == signals_.size()) {
    return std::nullopt;
  }
  const SkipSignal& signal = signals_[used_++];
  if (!signal.at) {
    return std::nullopt;
  }
  const int axis = signal.axis;
  const double from = to.axes_at ? to.axes_at(0.0)[axis] : points.front().q_M[axis];
  const double end = to.axes_at ? to.axes_at(1.0)[axis] : points.back().q_M[axis];
  if (from == end) {
    return std::nullopt;
  }
  const Edge edge{axis, *signal.at, end > from ? 1.0 : -1.0, to.edge};
  machine::SkipTrigger trigger;
  if (edge.is_reached_at(from)) {
    trigger.on_at_start = true;
    return trigger;
  }
  if (to.axes_at) {
    const auto fraction = where_reached(edge, points, to);
    if (!fraction) {
      return std::nullopt;
    }
    trigger.fraction = *fraction;
  } else {
    if (!edge.is_reached_at(end)) {
      return std::nullopt;
    }
    trigger.fraction = machine::fraction_at_share(points, (edge.at - from) / (end - from));
  }
  last_ = edge;
  return trigger;
}

std::optional<double> ScriptedSignals::where_reached(const Edge& edge,
                                                     std::span<const machine::Waypoint> points,
                                                     const machine::Listening& to) {
  const auto is_reached = [&](double fraction) {
    return edge.is_reached_at(to.axes_at(fraction)[edge.axis]);
  };
  const auto behind = std::ranges::find_if(points, is_reached, &machine::Waypoint::fraction);
  if (behind == points.end()) {
    return std::nullopt;
  }
  double low = (behind - 1)->fraction;
  double high = behind->fraction;
  for (double middle = std::midpoint(low, high); low < middle && middle < high;
       middle = std::midpoint(low, high)) {
    (is_reached(middle) ? high : low) = middle;
  }
  return high;
}

bool ScriptedSignals::signals_at(const machine::Waypoint& at, const machine::Listening& to) const {
  if (!last_) {
    return false;
  }
  const double place = (to.axes_at ? to.axes_at(0.0) : at.q_M)[last_->axis];
  return last_->is_reached_at(place) == (last_->edge == machine::SignalEdge::Rising);
}

std::optional<machine::Obstacle> ScriptedSignals::first_obstacle(const machine::Way& /*way*/,
                                                                 machine::Travel /*travel*/) {
  return std::nullopt;
}

}  // namespace g31::probe

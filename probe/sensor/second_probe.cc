#include "probe/sensor/second_probe.h"

#include <utility>

#include "machine/base/contract.h"

namespace g31::probe {

SecondProbe::SecondProbe(std::unique_ptr<machine::Surroundings> inner, const Place& place)
    : inner_(std::move(inner)), place_(place) {
  G31_EXPECTS(inner_ != nullptr);
}

machine::Waypoint SecondProbe::own(const machine::Waypoint& at) const {
  const auto& [p_T_beside, p_T_first, p_T_second] = place_;
  machine::Waypoint there = at;
  // The tool turns about the tip of the first probe.
  const bool is_tilted = at.tilt.coeffs() != Eigen::Quaterniond::Identity().coeffs();
  const Point from_first = p_T_beside + p_T_second - p_T_first;
  const Point turned = is_tilted ? Point(at.tilt * from_first) : from_first;
  there.q_M.head<kLinearAxisCount>() +=
      (is_tilted ? Point(p_T_first + turned - p_T_second) : p_T_beside) + at.lean_rad.cross(turned);
  return there;
}

template <typename Ask>
auto SecondProbe::along(const machine::Way& way, Ask ask) const {
  if (const machine::CurvedWay* const curve = way.curve()) {
    machine::CurvedWay led = *curve;
    led.q_M_at = [curve, beside = place_.p_T_beside](double fraction) {
      AxisPositions q_M = curve->q_M_at(fraction);
      q_M.head<kLinearAxisCount>() += beside;
      return q_M;
    };
    return ask(machine::Way(led));
  }
  std::vector<machine::Waypoint> points;
  points.reserve(way.points().size());
  for (const machine::Waypoint& point : way.points()) {
    points.push_back(own(point));
  }
  return ask(machine::Way(points));
}

std::optional<machine::SkipTrigger> SecondProbe::first_signal(const machine::Way& way,
                                                              const machine::Listening& to) {
  return along(way, [&](const machine::Way& led) { return inner_->first_signal(led, to); });
}

std::optional<machine::Obstacle> SecondProbe::first_obstacle(const machine::Way& way,
                                                             machine::Travel travel) {
  auto obstacle =
      along(way, [&](const machine::Way& led) { return inner_->first_obstacle(led, travel); });
  if (obstacle) {
    obstacle->what = "second probe: " + obstacle->what;
  }
  return obstacle;
}

bool SecondProbe::signals_at(const machine::Waypoint& at, const machine::Listening& to) const {
  return inner_->signals_at(own(at), to);
}

std::string SecondProbe::stands_inside(const machine::Waypoint& at) const {
  return inner_->stands_inside(own(at));
}

std::optional<machine::SensorState> SecondProbe::sensor_state(int input) const {
  return inner_->sensor_state(input);
}

machine::ToolExtent SecondProbe::tool_extent() const {
  machine::ToolExtent extent = inner_->tool_extent();
  extent.p_T_tip.reset();
  extent.signal_mm += place_.p_T_beside.norm();
  extent.body_mm += place_.p_T_beside.norm();
  return extent;
}

void SecondProbe::take(const machine::MachineEvent& event) {
  inner_->take(event);
}

void SecondProbe::time_is(double now_s) {
  inner_->time_is(now_s);
}

}  // namespace g31::probe

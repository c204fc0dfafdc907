#include "probe/sensor/world.h"

#include <algorithm>
#include <utility>

#include "machine/base/contract.h"

namespace g31::probe {
namespace {

/// The one whose fraction is less; the first of equals.
template <typename Event>
void keep_earlier(std::optional<Event>& first, std::optional<Event> next) {
  if (next && (!first || next->fraction < first->fraction)) {
    first = std::move(next);
  }
}

}  // namespace

World::World(Sets sets, Tools tools, std::unique_ptr<DisplacementSensors> sensors)
    : sets_(std::move(sets)), tools_(tools), sensors_(std::move(sensors)) {
  G31_EXPECTS(std::ranges::none_of(sets_, [](const auto& set) { return set == nullptr; }));
}

std::optional<machine::SkipTrigger> World::first_signal(const machine::Way& way,
                                                        const machine::Listening& to) {
  // Where one set is in place, the line is its own; else it is as low as all leave it.
  const auto line = sensor_state(to.input);
  std::optional<machine::SkipTrigger> first;
  for (const auto& set : sets_) {
    const auto state = set->sensor_state(to.input);
    if (state && state->in_place == line->in_place) {
      keep_earlier(first, set->first_signal(way, to));
    }
  }
  return first;
}

std::optional<machine::Obstacle> World::first_obstacle(const machine::Way& way,
                                                       machine::Travel travel) {
  std::optional<machine::Obstacle> first;
  for (const auto& set : sets_) {
    keep_earlier(first, set->first_obstacle(way, travel));
  }
  return first;
}

bool World::signals_at(const machine::Waypoint& at, const machine::Listening& to) const {
  return std::ranges::any_of(sets_, [&](const auto& set) { return set->signals_at(at, to); });
}

std::string World::stands_inside(const machine::Waypoint& at) const {
  for (const auto& set : sets_) {
    if (std::string part = set->stands_inside(at); !part.empty()) {
      return part;
    }
  }
  return {};
}

std::optional<machine::SensorState> World::sensor_state(int input) const {
  std::optional<machine::SensorState> first;
  for (const auto& set : sets_) {
    const auto state = set->sensor_state(input);
    if (state && (!first || (state->in_place && !first->in_place))) {
      first = state;
    }
  }
  return first;
}

std::optional<Point> World::displacement_sensor(int input) const {
  return sensors_ != nullptr ? sensors_->place(input) : std::nullopt;
}

double World::displacement(const machine::Waypoint& at, int input) const {
  G31_EXPECTS(sensors_ != nullptr);
  return sensors_->reading(input, at, now_s_);
}

machine::ToolExtent World::tool_extent() const {
  machine::ToolExtent most;
  for (const auto& set : sets_) {
    const machine::ToolExtent extent = set->tool_extent();
    most.p_T_tip = most.p_T_tip ? most.p_T_tip : extent.p_T_tip;
    most.signal_mm = std::max(most.signal_mm, extent.signal_mm);
    most.body_mm = std::max(most.body_mm, extent.body_mm);
  }
  if (!most.p_T_tip && tools_ == Tools::Changing) {
    most.p_T_tip = Point(0.0, 0.0, -called_.length_mm);
  }
  return most;
}

void World::take(const machine::MachineEvent& event) {
  if (const auto* const change = std::get_if<machine::ToolChange>(&event)) {
    called_ = change->tool;
  }
  for (const auto& set : sets_) {
    set->take(event);
  }
}

void World::time_is(double now_s) {
  now_s_ = now_s;
  for (const auto& set : sets_) {
    set->time_is(now_s);
  }
}

}  // namespace g31::probe

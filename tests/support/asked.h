#pragma once

#include <array>
#include <optional>
#include <span>

#include "machine/port/surroundings.h"

namespace g31::testing {

/// The linear axes there, the others at 0.
inline AxisPositions at(const Point& p) {
  AxisPositions q = AxisPositions::Zero();
  q.head<kLinearAxisCount>() = p;
  return q;
}

// What a world says to one straight piece or curve.

inline std::array<machine::Waypoint, 2> ends_of(const machine::Sweep& sweep) {
  return {start_of(sweep), end_of(sweep)};
}

inline std::optional<machine::SkipTrigger> touch_on(machine::Surroundings& world,
                                                    const machine::Sweep& sweep) {
  return world.first_signal(machine::Way(ends_of(sweep)), {});
}

inline std::optional<machine::Obstacle> collision_on(machine::Surroundings& world,
                                                     const machine::Sweep& sweep) {
  return world.first_obstacle(machine::Way(ends_of(sweep)), machine::Travel::Feed);
}

inline std::optional<machine::Obstacle> collision_on(machine::Surroundings& world,
                                                     const machine::CurvedWay& way) {
  return world.first_obstacle(machine::Way(way), machine::Travel::Feed);
}

inline std::optional<machine::Obstacle> damage_on(machine::Surroundings& world,
                                                  const machine::Sweep& sweep) {
  return world.first_obstacle(machine::Way(ends_of(sweep)), machine::Travel::Skip);
}

// And to one of several points.

inline std::optional<machine::SkipTrigger> touch_along(machine::Surroundings& world,
                                                       std::span<const machine::Waypoint> way) {
  return world.first_signal(machine::Way(way), {});
}

inline std::optional<machine::SkipTrigger> release_along(machine::Surroundings& world,
                                                         std::span<const machine::Waypoint> way) {
  return world.first_signal(machine::Way(way), {machine::kAnyInput, machine::SignalEdge::Falling});
}

}  // namespace g31::testing

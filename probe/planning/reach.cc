#include "probe/planning/reach.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "machine/port/way.h"

namespace g31::probe {
namespace {

using Why = std::optional<std::string>;
using Ends = std::array<machine::Waypoint, 2>;

/// No probe resolves so little; walls of meshes lean by more than their corners are rounded, where
/// their facets are narrow.
constexpr double kUnseenMm = 1e-4;
/// Of sums of some coordinates.
constexpr double kSumRoundingMm = 1e-9;

}  // namespace

AxisPositions Reach::axes_at(const Point& p_P_ball) const {
  AxisPositions q_M = AxisPositions::Zero();
  q_M.head<3>() = way_.p_M_product + p_P_ball - way_.p_S_ball;
  return q_M;
}

Why Reach::obstacle(const Point& p_P_from, const Point& p_P_to, machine::Travel travel) {
  if (p_P_from == p_P_to) {
    return std::nullopt;
  }
  const Ends ends = {machine::Waypoint{0.0, axes_at(p_P_from)},
                     machine::Waypoint{1.0, axes_at(p_P_to)}};
  const auto met = world_.first_obstacle(machine::Way(ends), travel);
  return met ? Why(met->what) : std::nullopt;
}

Why Reach::beyond_travel(const Point& p_P_ball) const {
  const AxisPositions q_M = axes_at(p_P_ball);
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const double limit = std::clamp(q_M[axis], way_.q_M_least[axis], way_.q_M_most[axis]);
    if (std::abs(q_M[axis] - limit) > kSumRoundingMm) {
      return fmt::format("axis {} would have to go to {:.3f} mm, its travel ends at {:g} mm",
                         kAxisLetters[static_cast<std::size_t>(axis)], q_M[axis], limit);
    }
  }
  return std::nullopt;
}

Why Reach::problem(const PlannedPoint& point, double surface_error_mm) {
  const Point above(point.start_P.x(), point.start_P.y(),
                    std::max(way_.clear_z_P, point.start_P.z()));
  const double depth = way_.ball_radius_mm - way_.overtravel_mm;
  const Point end = point.at_P + depth * point.normal_P;
  for (const Point& place : {above, point.start_P, end}) {
    if (auto why = beyond_travel(place)) {
      return why;
    }
  }
  if (auto why = obstacle(above, point.start_P, machine::Travel::Feed)) {
    return fmt::format("{} on the way down", *why);
  }
  const Ends ends = {machine::Waypoint{0.0, axes_at(point.start_P)},
                     machine::Waypoint{1.0, axes_at(end)}};
  const auto signal = world_.first_signal(machine::Way(ends), {});
  if (!signal || signal->on_at_start) {
    return signal ? "the ball stands in the material at the start" : "there is nothing to touch";
  }
  const double expected = (point.start_P - point.at_P).dot(point.normal_P) - way_.ball_radius_mm;
  const double run = signal->fraction * (end - point.start_P).norm();
  if (std::abs(run - expected) > kUnseenMm + surface_error_mm) {
    const double off = std::abs(run - expected);
    const std::string shown = off < 0.001 ? fmt::format("{:.1g}", off) : fmt::format("{:.3f}", off);
    return fmt::format("the ball touches {} mm {}", shown, run < expected ? "earlier" : "later");
  }
  const Point touch = point.start_P - run * point.normal_P;
  if (auto why = obstacle(point.start_P, touch, machine::Travel::Skip)) {
    return fmt::format("{} during the touch", *why);
  }
  return std::nullopt;
}

}  // namespace g31::probe

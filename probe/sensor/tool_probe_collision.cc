// The part of ToolProbe that answers what must not touch.

#include <algorithm>

#include <fmt/format.h>

#include "probe/sensor/tool_probe.h"
#include "probe/sensor/touch_events.h"

namespace g31::probe {

std::string ToolProbe::tool_name() const {
  return fmt::format("tool T{}", held_->setup.number);
}

std::optional<machine::Obstacle> ToolProbe::first_obstacle(const machine::Way& way,
                                                           machine::Travel travel) {
  if (held_ == nullptr || setup_.shape == ToolProbeShape::Laser) {
    return std::nullopt;
  }
  auto obstacle = obstacle_along(bed_.from_carrier(way), travel);
  if (obstacle) {
    obstacle->contact = bed_.for_part(obstacle->contact, way, obstacle->fraction);
  }
  return obstacle;
}

std::optional<machine::Obstacle> ToolProbe::obstacle_along(Points way,
                                                           machine::Travel travel) const {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const machine::Waypoint& from = way[i - 1];
    const machine::Waypoint& to = way[i];
    if (!machine::differ(from, to) || !comes_near(from, to)) {
      continue;
    }
    auto obstacle =
        travel == machine::Travel::Skip ? damage_on(from, to) : collision_on(pieces(), from, to);
    if (auto body = collision_on(held_->shape.bodies, from, to);
        body && (!obstacle || body->fraction < obstacle->fraction)) {
      obstacle = std::move(body);
      obstacle->what = fmt::format("holder of {} touches {}", tool_name(), setup_.name);
    }
    if (obstacle) {
      obstacle->fraction = machine::fraction_between(from, to, obstacle->fraction);
      return obstacle;
    }
  }
  return std::nullopt;
}

bool ToolProbe::comes_near(const machine::Waypoint& from, const machine::Waypoint& to) const {
  const Point p_from = linear_axes(from.q_M) + held_->shape.p_T_tip;
  const Point along = linear_axes(to.q_M) + held_->shape.p_T_tip - p_from;
  const Point gap = p_M_middle_ - p_from;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(gap.dot(along) / squared, 0.0, 1.0) : 0.0;
  // A tool that is turned against the part turns about its tip.
  return (gap - share * along).norm() <= held_->shape.reach_mm + plate_reach_mm_ + kCastErrorMm;
}

/// A tool that touches may leave: all shapes are convex.  Else the first touch on the way counts.
std::optional<machine::Obstacle> ToolProbe::collision_on(const Pieces& pieces,
                                                         const machine::Waypoint& from,
                                                         const machine::Waypoint& to) const {
  const std::string what = fmt::format("{} touches {}", tool_name(), setup_.name);
  if (const Depth depth = depth_of(pieces, from); depth.mm >= -kCastErrorMm) {
    constexpr double kSideways = 1e-9;
    const Point along = linear_axes(to.q_M) - linear_axes(from.q_M);
    const bool leaves = along.dot(depth.n_M) >= -kSideways * along.norm();
    return leaves && depth.mm <= setup_.deflection_limit_mm
               ? std::nullopt
               : std::optional(machine::Obstacle{
                     0.0, what, contact_of({0.0, depth.n_M, target().furthest(depth.n_M)})});
  }
  const auto touch = first_touch(pieces, from, to);
  return touch ? std::optional(machine::Obstacle{touch->fraction, what, contact_of(*touch)})
               : std::nullopt;
}

/// On a skip move the plate gives way, along the normal of the touch, but no further than it can.
std::optional<machine::Obstacle> ToolProbe::damage_on(const machine::Waypoint& from,
                                                      const machine::Waypoint& to) const {
  const Point along = linear_axes(to.q_M) - linear_axes(from.q_M);
  const Depth at_start = depth_of(pieces(), from);
  Touch touch{0.0, at_start.n_M, Point::Zero()};
  if (at_start.mm < -kCastErrorMm) {
    const auto met = first_touch(pieces(), from, to);
    if (!met) {
      return std::nullopt;
    }
    touch = *met;
  }
  const double depth = std::max(0.0, at_start.mm);
  const double inwards = -touch.n_M.dot(along);
  const double limit = setup_.deflection_limit_mm;
  if (inwards <= 0.0 || depth + (1.0 - touch.fraction) * inwards <= limit) {
    return std::nullopt;
  }
  touch.fraction = std::min(1.0, touch.fraction + std::max(0.0, limit - depth) / inwards);
  touch.p_M = target().furthest(touch.n_M);
  return machine::Obstacle{touch.fraction, pushed_too_deep(tool_name(), limit, setup_.name),
                           contact_of(touch)};
}

}  // namespace g31::probe

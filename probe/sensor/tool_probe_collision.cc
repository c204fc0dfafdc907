// The part of ToolProbe that answers what must not touch.

#include <algorithm>

#include <fmt/format.h>

#include "probe/sensor/tool_probe.h"

namespace g31::probe {

std::string ToolProbe::tool_name() const {
  return fmt::format("tool T{}", held_->setup.number);
}

std::optional<machine::Obstacle> ToolProbe::first_obstacle(const machine::Way& way,
                                                           machine::Travel travel) {
  if (held_ == nullptr || setup_.shape == ToolProbeShape::Laser) {
    return std::nullopt;
  }
  const std::vector<machine::Waypoint> points = machine::points_of(way);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const machine::Waypoint& from = points[i - 1];
    const machine::Waypoint& to = points[i];
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

/// What touches leaves again, for all of it is convex; what does not may come to touch.
std::optional<machine::Obstacle> ToolProbe::collision_on(const Pieces& pieces,
                                                         const machine::Waypoint& from,
                                                         const machine::Waypoint& to) const {
  const std::string what = fmt::format("{} touches {}", tool_name(), setup_.name);
  if (const Depth depth = depth_of(pieces, from); depth.mm >= -kCastErrorMm) {
    constexpr double kSideways = 1e-9;
    const Point along = linear_axes(to.q_M) - linear_axes(from.q_M);
    return along.dot(depth.n_M) >= -kSideways * along.norm()
               ? std::nullopt
               : std::optional(machine::Obstacle{
                     0.0, what, contact_of({0.0, depth.n_M, target().furthest(depth.n_M)})});
  }
  const auto touch = first_touch(pieces, from, to);
  return touch ? std::optional(machine::Obstacle{touch->fraction, what, contact_of(*touch)})
               : std::nullopt;
}

/// On a skip move the plate gives way, but no further than it can.
std::optional<machine::Obstacle> ToolProbe::damage_on(const machine::Waypoint& from,
                                                      const machine::Waypoint& to) const {
  const Depth at_end = depth_of(pieces(), to);
  const double limit = setup_.deflection_limit_mm;
  if (at_end.mm <= limit) {
    return std::nullopt;
  }
  const Depth at_start = depth_of(pieces(), from);
  const Point along = linear_axes(to.q_M) - linear_axes(from.q_M);
  const double deeper = -along.dot(at_end.n_M);
  if (at_start.mm >= at_end.mm || deeper <= 0.0) {
    return std::nullopt;
  }
  const double broken_at = std::clamp(1.0 - (at_end.mm - limit) / deeper, 0.0, 1.0);
  return machine::Obstacle{broken_at,
                           fmt::format("{} is pushed {:.3f} mm into {}, its deflection limit",
                                       tool_name(), limit, setup_.name),
                           contact_of({broken_at, at_end.n_M, target().furthest(at_end.n_M)})};
}

}  // namespace g31::probe

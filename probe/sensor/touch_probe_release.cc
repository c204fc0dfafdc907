// The part of TouchProbe that answers when the stylus comes free.

#include <cmath>
#include <utility>

#include "parts/geometry/winding_number.h"
#include "probe/sensor/release.h"
#include "probe/sensor/touch_probe.h"

namespace g31::probe {
std::optional<TouchProbe::PartHit> TouchProbe::signalling_touch(const machine::Waypoint& at) const {
  const machine::Sweep still = machine::sweep_between(at, at);
  for (const Tip& ball : balls_) {
    const BallWay way = way_of(ball, still);
    for (const Part& part : parts_->parts()) {
      if (!kSensed.is_of(part)) {
        continue;
      }
      const MeshSweeper& sweeper = part.sweepers[ball.size];
      const auto distance = sweeper.distance_if_touching(way.p_M_from);
      if (!distance) {
        continue;
      }
      const PartHit touch{sweeper.sweep(way.p_M_from, way.p_M_to), &part, &ball, way};
      const auto wanted = deflection_wanted(touch.hit.n_M, at.tilt);
      if (wanted && ball.radius - *distance >= *wanted - kTouchBandMm) {
        return touch;
      }
    }
  }
  return std::nullopt;
}

std::string TouchProbe::stands_inside(const machine::Waypoint& at) const {
  constexpr double kInside = 0.5;
  if (!is_in_place_) {
    return {};
  }
  for (const Tip& ball : balls_) {
    const Point p_M = centre_of(ball, at);
    for (const Part& part : parts_->parts()) {
      const parts::Path here{p_M, Point::UnitX(), 0.0};
      if (part.is_solid && part.mesh->tree().may_meet(here, 0.0) &&
          std::fabs(parts::winding_number(part.mesh->mesh(), p_M)) > kInside) {
        return part.name;
      }
    }
  }
  return {};
}

bool TouchProbe::signals_at(const machine::Waypoint& at, int input) const {
  return is_wired(input) && !is_silent() && signalling_touch(at).has_value();
}

std::optional<machine::SkipTrigger> TouchProbe::first_release_along(Points way) {
  const std::uint64_t event = triggers_asked_++;
  auto touch = signalling_touch(way.front());
  if (!touch) {
    return machine::SkipTrigger{0.0, true, 0.0, std::nullopt};
  }
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const machine::Waypoint& from = way[i - 1];
    const machine::Waypoint& to = way[i];
    const double piece = machine::distance_mm(from.q_M, to.q_M);
    if (auto next = signalling_touch(to)) {
      touch = std::move(next);
      length += piece;
      continue;
    }
    const double off = share_to_release(
        from, to, [this](const machine::Waypoint& at) { return signalling_touch(at).has_value(); });
    machine::SkipTrigger trigger = trigger_of(*touch);
    trigger.delay_s = setup_.trigger_delay_s;
    trigger.fraction = machine::fraction_after(way, length + off * piece + trigger_shift(event));
    return trigger;
  }
  return std::nullopt;
}

}  // namespace g31::probe

// The part of TouchProbe that answers when the stylus comes free.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "parts/geometry/winding_number.h"
#include "probe/sensor/release.h"
#include "probe/sensor/touch_probe.h"

namespace g31::probe {

std::vector<TouchProbe::PartHit> TouchProbe::touches_of(const Tip& ball,
                                                        const machine::Waypoint& at) const {
  const BallWay here = way_of(ball, machine::sweep_between(at, at));
  std::vector<PartHit> touches;
  for (const Part& part : parts_->parts()) {
    if (!kSensed.is_of(part)) {
      continue;
    }
    for (const SweepHit& hit : part.sweepers[ball.size].contacts_at(here.p_M_from)) {
      touches.push_back({hit, &part, &ball, here});
      touches.back().depth = depth_of(touches.back());
    }
  }
  if (touches.size() > 1) {
    const PartHit deepest = *std::ranges::max_element(touches, {}, &PartHit::depth);
    std::erase_if(touches, [&](const PartHit& touch) {
      const double pushed_out = deepest.depth * deepest.hit.n_M.dot(touch.hit.n_M);
      return touch.depth < pushed_out - kTouchBandMm;
    });
  }
  return touches;
}

std::optional<TouchProbe::PartHit> TouchProbe::signalling_touch(const machine::Waypoint& at) const {
  for (const Tip& ball : balls_) {
    for (const PartHit& touch : touches_of(ball, at)) {
      const auto wanted = deflection_wanted(touch.hit.n_M, at.tilt);
      if (wanted && touch.depth >= *wanted - kTouchBandMm) {
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

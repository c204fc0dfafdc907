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

bool TouchProbe::signals_at(const machine::Waypoint& at, const machine::Listening& to) const {
  return is_wired(to.input) && !is_silent() && signalling_touch(at).has_value();
}

std::optional<machine::SkipTrigger> TouchProbe::first_release_along(Points way) {
  const std::uint64_t event = triggers_asked_++;
  auto touch = signalling_touch(way.front());
  if (!touch) {
    return machine::SkipTrigger{0.0, true, 0.0, std::nullopt};
  }
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double piece = machine::distance_mm(way[i - 1].q_M, way[i].q_M);
    if (const auto off = release_on(way[i - 1], way[i], *touch)) {
      machine::SkipTrigger trigger = trigger_of(*touch);
      trigger.delay_s = setup_.trigger_delay_s;
      trigger.fraction = machine::fraction_after(way, length + *off * piece + trigger_shift(event));
      return trigger;
    }
    length += piece;
  }
  return std::nullopt;
}

std::optional<double> TouchProbe::release_on(const machine::Waypoint& from,
                                             const machine::Waypoint& to, PartHit& touch) const {
  // Where a hollow surface is left at a slant, a few steps lead out of it.
  constexpr int kMostSteps = 100;
  double on = 0.0;
  for (int step = 0; on < 1.0; ++step) {
    const machine::Waypoint here = between(from, to, on);
    const double share = step < kMostSteps ? share_to_off(touch, here, to) : 1.0;
    const double next = std::min(1.0, on + (1.0 - on) * share);
    const machine::Waypoint there = next < 1.0 ? between(from, to, next) : to;
    auto then = signalling_touch(there);
    if (!then) {
      const auto is_on = [this](const machine::Waypoint& at) {
        return signalling_touch(at).has_value();
      };
      return on + (next - on) * share_to_release(here, there, is_on);
    }
    touch = *std::move(then);
    on = next;
  }
  return std::nullopt;
}

double TouchProbe::share_to_off(const PartHit& touch, const machine::Waypoint& at,
                                const machine::Waypoint& to) const {
  const Point p_M_to = centre_of(*touch.ball, to);
  const double outwards = touch.hit.n_M.dot(p_M_to - touch.way.p_M_from);
  const double wanted = deflection_wanted(touch.hit.n_M, at.tilt).value_or(0.0);
  // A signal is on until the touch is out by the touch band.
  const double on_tangent_plane = touch.depth - wanted + 2.0 * kTouchBandMm;
  if (outwards > on_tangent_plane) {
    return on_tangent_plane / outwards;
  }
  // Over an edge the ball leaves all of the part before its tangent plane.
  return touch.part->sweepers[touch.ball->size]
      .leave(touch.way.p_M_from, p_M_to, touch.ball->radius, kLeaveAtAnyDepth)
      .share;
}

}  // namespace g31::probe

// The part of TouchProbe that says how far a ball is pressed in where tangent planes do not: over
// edges, along what curves, and where a surface ends.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "probe/sensor/pressed_surfaces.h"
#include "probe/sensor/release.h"
#include "probe/sensor/touch_events.h"
#include "probe/sensor/touch_probe.h"

namespace g31::probe {
namespace {

/// What tangent planes say is taken where the surfaces say the same within this.
constexpr double kSameDepthMm = 1e-6;

/// Where a ball slides along just before the depth wanted, it is looked at again after so much: a
/// place that is deep enough over less than that may be missed.
constexpr double kLeastStepMm = 1e-3;
constexpr int kMostSteps = 20000;

}  // namespace

std::optional<TouchProbe::Pressing> TouchProbe::pressing_at(const Tip& ball,
                                                            const machine::Waypoint& at,
                                                            const Need& need) const {
  std::optional<Pressing> nearest;
  for (const PartHit& touch : touches_of(ball, at)) {
    const auto wanted = need(touch.hit.n_M);
    if (wanted && (!nearest || *wanted - touch.depth < nearest->missing)) {
      nearest = Pressing{0.0, *wanted - touch.depth, touch};
    }
  }
  return nearest;
}

double TouchProbe::next_contact(const Tip& ball, const BallWay& way, double s) const {
  const Point p_M = way.p_M_from + (s / way.length) * way.along();
  double first = std::numeric_limits<double>::infinity();
  for (const Part& part : parts_->parts()) {
    if (kSensed.is_of(part)) {
      const SweepHit hit = part.sweepers[ball.size].sweep(p_M, way.p_M_to);
      first = hit.status == SweepStatus::Miss ? first : std::min(first, s + hit.s);
    }
  }
  return first;
}

std::optional<TouchProbe::Pressing> TouchProbe::first_pressing(const Tip& ball,
                                                               const machine::Sweep& sweep,
                                                               double from,
                                                               const Need& need) const {
  const BallWay way = way_of(ball, sweep);
  const double least_step = std::max(kLeastStepMm, way.length / kMostSteps);
  const auto at = [&](double s) {
    auto pressing =
        pressing_at(ball, between(start_of(sweep), end_of(sweep), s / way.length), need);
    if (pressing) {
      pressing->s = s;
    }
    return pressing;
  };
  // A ball whose centre has gone through a surface is pushed out on the other side.
  Point n_M_before = Point::Zero();
  const auto is_reached = [&](const std::optional<Pressing>& pressing) {
    return pressing &&
           (pressing->missing <= kTouchBandMm || pressing->touch.hit.n_M.dot(n_M_before) < 0.0);
  };
  double before = from;
  for (double s = from; s <= way.length;) {
    const auto pressing = at(s);
    if (is_reached(pressing)) {
      constexpr int kHalvings = 60;
      Pressing first = *pressing;
      for (int i = 0; i < kHalvings && before < first.s; ++i) {
        const auto middle = at(0.5 * (before + first.s));
        if (is_reached(middle)) {
          first = *middle;
        } else {
          before = 0.5 * (before + first.s);
        }
      }
      return first;
    }
    before = s;
    n_M_before = pressing ? pressing->touch.hit.n_M : Point::Zero();
    // No deflection grows faster than the way.
    const double step = pressing ? pressing->missing : next_contact(ball, way, s) - s;
    s = s < way.length ? std::min(way.length, s + std::max(step, least_step)) : way.length + 1.0;
  }
  return std::nullopt;
}

void TouchProbe::settle(Search& search, const machine::Sweep& sweep, const Pressed& pressed) const {
  const SwitchSetup& at_switch = setup_.at_switch;
  const bool is_at_contact = at_switch.pre_travel_mm == 0.0 && at_switch.trigger_force_n == 0.0;
  std::optional<Signal>& first = search.first;
  if (is_at_contact || (first && first->on_at_start)) {
    return;
  }
  const BallWay way = way_of(search.ball, sweep);
  const double begin = search.gone - way.length;
  const Need need = [&](const Point& n_M) { return deflection_wanted(n_M, sweep.tilt_from); };
  const bool is_here = first && first->distance <= search.gone;
  const double looked_at = is_here ? std::max(0.0, first->distance - begin) : way.length;
  const auto there = pressing_at(
      search.ball, between(start_of(sweep), end_of(sweep), looked_at / way.length), need);
  const bool is_as_said = is_here ? there && std::fabs(there->missing) <= kSameDepthMm
                                  : !there || there->missing > kSameDepthMm;
  if (is_as_said) {
    return;
  }
  const auto exact = first_pressing(search.ball, sweep, std::min(pressed.s, way.length), need);
  if (exact) {
    const bool is_first_met = exact->touch.part == pressed.part;
    const SweepHit& hit = is_first_met ? pressed.hit : exact->touch.hit;
    first = Signal{{hit, exact->touch.part, &search.ball, way}, begin + exact->s, false};
  } else if (is_here) {
    first.reset();
  }
}

std::optional<machine::Obstacle> TouchProbe::over_limit(const Tip& ball,
                                                        const machine::Sweep& sweep,
                                                        double from) const {
  const BallWay way = way_of(ball, sweep);
  if (way.length == 0.0) {
    return std::nullopt;
  }
  const double limit = limit_of(ball);
  const auto broken =
      first_pressing(ball, sweep, from, [&](const Point&) { return std::optional(limit); });
  // One that begins deeper in may come out.
  const bool comes_out =
      broken && broken->s == from && broken->touch.hit.n_M.dot(way.along()) >= 0.0;
  if (!broken || comes_out) {
    return std::nullopt;
  }
  const std::string& part = broken->touch.part->name;
  return machine::Obstacle{
      broken->s / way.length,
      fmt::format("stylus is pushed {:.3f} mm into {}, its deflection limit", limit, part),
      contact_of(broken->touch.hit, part)};
}

}  // namespace g31::probe

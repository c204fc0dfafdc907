// The part of TouchProbe that says how far a ball is pressed in where tangent planes do not: over
// edges, along what curves, and where a surface ends.  It asks how near the surfaces are to the
// centre of the ball that nothing deflects, which is all where one of them holds the ball; between
// two or more that wedge it the tangent planes count (pressed_surfaces.h).

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "probe/contact/smooth_normal.h"
#include "probe/sensor/pressed_surfaces.h"
#include "probe/sensor/release.h"
#include "probe/sensor/touch_events.h"
#include "probe/sensor/touch_probe.h"

namespace g31::probe {
namespace {

/// What tangent planes say is taken where the surfaces say the same within this.
constexpr double kSameDepthMm = 1e-6;

/// Where a ball slides along just before the depth wanted, it is looked at again after so much: a
/// place that is deep enough over less than that may be missed, and after so many looks over less
/// than such a share of the way.
constexpr double kLeastStepMm = 1e-3;
constexpr int kMostSteps = 20000;

machine::Waypoint place_on(const machine::Sweep& sweep, double share) {
  return between(start_of(sweep), end_of(sweep), share);
}

}  // namespace

std::optional<TouchProbe::Pressing> TouchProbe::pressing_at(const Tip& ball,
                                                            const machine::Waypoint& at,
                                                            const Need& need) const {
  const std::vector<PartHit> touches = touches_of(ball, at);
  std::optional<Pressing> nearest;
  for (const PartHit& touch : touches) {
    const auto wanted = need(touch.hit.n_M);
    if (wanted && (!nearest || *wanted - touch.depth < nearest->missing)) {
      nearest = Pressing{0.0, *wanted - touch.depth, touches.size() == 1, touch};
    }
  }
  return nearest;
}

double TouchProbe::next_contact(const Tip& ball, const BallWay& way, double s) const {
  const Point p_M = way.p_M_from + (s / way.length) * way.along();
  const auto met =
      PressedSurfaces::first_met(parts_->parts(), {ball.radius, ball.size}, p_M, way.p_M_to);
  return met ? s + met->hit.s : std::numeric_limits<double>::infinity();
}

TouchProbe::FirstPressing TouchProbe::first_pressing(const Tip& ball, const machine::Sweep& sweep,
                                                     double from, const Need& need) const {
  const BallWay way = way_of(ball, sweep);
  // A ball whose centre has gone through a surface is pushed out on the other side.
  Point n_M_before = Point::Zero();
  const auto is_reached = [&](const std::optional<Pressing>& pressing) {
    return pressing && (pressing->missing <= 0.0 || pressing->touch.hit.n_M.dot(n_M_before) < 0.0);
  };
  const auto is_missing = [&](const machine::Waypoint& at) {
    return !is_reached(pressing_at(ball, at, need));
  };
  double before = from;
  double s = from;
  for (int looks = 0;; ++looks) {
    const machine::Waypoint here = place_on(sweep, s / way.length);
    auto pressing = pressing_at(ball, here, need);
    if (pressing && !pressing->is_alone) {
      return {false, std::nullopt};
    }
    if (is_reached(pressing)) {
      const double share = share_to_release(place_on(sweep, before / way.length), here, is_missing);
      pressing->s = before + share * (s - before);
      return {true, pressing};
    }
    if (s >= way.length) {
      return {true, std::nullopt};
    }
    const double least_step = looks < kMostSteps ? kLeastStepMm : way.length / kMostSteps;
    // Only where the centre is as near to the surface as a step can it be on its other side next.
    const bool is_at_centre = pressing && ball.radius - pressing->touch.depth <= least_step;
    n_M_before = is_at_centre ? pressing->touch.hit.n_M : Point::Zero();
    before = s;
    // No deflection grows faster than the way.
    const double step = pressing ? pressing->missing : next_contact(ball, way, s) - s;
    s = std::min(way.length, s + std::max(step, least_step));
  }
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
  const auto there = pressing_at(search.ball, place_on(sweep, looked_at / way.length), need);
  const bool is_as_said = is_here ? there && std::fabs(there->missing) <= kSameDepthMm
                                  : !there || there->missing > kSameDepthMm;
  if (is_as_said || (there && !there->is_alone)) {
    return;
  }
  const FirstPressing exact =
      first_pressing(search.ball, sweep, std::min(pressed.s, way.length), need);
  if (!exact.is_decided) {
    return;
  }
  if (exact.at) {
    const PartHit& touch = exact.at->touch;
    const bool is_met_first =
        touch.part == pressed.part && touch.hit.n_M.dot(pressed.hit.n_M) >= kCreaseCosine;
    const SweepHit& hit = is_met_first ? pressed.hit : touch.hit;
    first = Signal{{hit, touch.part, &search.ball, way}, begin + exact.at->s, false};
  } else if (is_here) {
    first.reset();
  }
}

void TouchProbe::settle_limit(std::optional<machine::Obstacle>& broken, const Tip& ball,
                              const machine::Sweep& sweep, double from) const {
  const BallWay way = way_of(ball, sweep);
  const double limit = limit_of(ball);
  const Need need = [limit](const Point&) { return std::optional(limit); };
  const auto there =
      broken ? pressing_at(ball, place_on(sweep, broken->fraction), need) : std::nullopt;
  if (there && (!there->is_alone || std::fabs(there->missing) <= kSameDepthMm)) {
    return;
  }
  const FirstPressing exact = first_pressing(ball, sweep, from, need);
  if (!exact.is_decided) {
    return;
  }
  // One that begins deeper in may come out.
  const bool comes_out =
      exact.at && exact.at->s == from && exact.at->touch.hit.n_M.dot(way.along()) >= 0.0;
  if (!exact.at || comes_out) {
    broken.reset();
    return;
  }
  const std::string& part = exact.at->touch.part->name;
  broken = machine::Obstacle{exact.at->s / way.length, pushed_too_deep("stylus", limit, part),
                             contact_of(exact.at->touch.hit, part)};
}

}  // namespace g31::probe

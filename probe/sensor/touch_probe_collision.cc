// The part of TouchProbe that answers what must not touch.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "probe/contact/sweep_curve.h"
#include "probe/sensor/touch_events.h"
#include "probe/sensor/touch_probe.h"

namespace g31::probe {
namespace {

machine::Obstacle obstacle_at(double fraction, const SweepHit& hit, const std::string& part) {
  return {std::clamp(fraction, 0.0, 1.0), "stylus ball touches " + part, contact_of(hit, part)};
}

std::optional<machine::Obstacle> earlier(std::optional<machine::Obstacle> a,
                                         std::optional<machine::Obstacle> b) {
  if (!a || (b && b->fraction < a->fraction)) {
    return b;
  }
  return a;
}

}  // namespace

std::optional<machine::Obstacle> TouchProbe::first_obstacle(const machine::Way& way,
                                                            machine::Travel travel) {
  if (!is_in_place_) {
    return std::nullopt;
  }
  if (way.curve() != nullptr) {
    return collision_on(*way.curve());
  }
  const Points points = way.points();
  for (std::size_t i = 1; i < points.size(); ++i) {
    const machine::Waypoint& from = points[i - 1];
    const machine::Waypoint& to = points[i];
    if (!machine::differ(from, to)) {
      continue;
    }
    const machine::Sweep sweep = machine::sweep_between(from, to);
    auto obstacle = travel == machine::Travel::Skip ? damage_on(sweep) : collision_on(sweep);
    if (obstacle) {
      obstacle->fraction = machine::fraction_between(from, to, obstacle->fraction);
      return obstacle;
    }
  }
  return std::nullopt;
}

std::optional<machine::Obstacle> TouchProbe::collision_on(const machine::Sweep& sweep) const {
  auto rigid = rigid_touch(sweep);
  const PartHit touch = first_hit(sweep, &MeshSweeper::first_contact_leaving, kBarred);
  if (touch.part == nullptr) {
    return rigid;
  }
  auto ball = obstacle_at(touch.fraction(), touch.hit, touch.part->name);
  return earlier(std::move(rigid), std::move(ball));
}

std::optional<machine::Obstacle> TouchProbe::collision_on(const machine::CurvedWay& curve) const {
  std::optional<machine::Obstacle> first = rigid_touch_on_curve(curve, 0.0, 1.0);
  for (const Tip& ball : balls_) {
    const Curve of_ball{[&](double t) {
                          return centre_of(ball, {t, curve.q_M_at(t)});
                        },
                        curve.bend};
    for (const Part& part : parts_->parts()) {
      if (!kBarred.is_of(part)) {
        continue;
      }
      const auto [t, hit] = first_contact_leaving_on_curve(part.sweepers[ball.size], of_ball);
      if (hit.status != SweepStatus::Miss) {
        first = earlier(std::move(first), obstacle_at(t, hit, part.name));
      }
    }
  }
  return first;
}

std::optional<machine::Obstacle> TouchProbe::damage_on(const machine::Sweep& sweep) const {
  std::optional<machine::Obstacle> broken;
  double pushed_from = 2.0;
  for (const Tip& ball : balls_) {
    const BallWay way = way_of(ball, sweep);
    PressedSurfaces surfaces = surfaces_on(ball, way);
    double until = way.length;
    std::optional<machine::Obstacle> of_ball;
    std::optional<Pressed> first;
    // From a free start no deflection is longer than the way since the first touch.
    const auto is_short_of_limit = [&](const Pressed& surface) {
      return surface.is_from_free && way.length - surface.s <= limit_of(ball);
    };
    while (const auto surface = surfaces.next(until)) {
      first = first ? first : surface;
      if (surface->hit.n_M.dot(way.along()) < 0.0) {
        pushed_from = std::min(pushed_from, way.length > 0.0 ? surface->s / way.length : 0.0);
      }
      if (auto obstacle = over_deflection(*surface, ball, way)) {
        until = obstacle->fraction * way.length;
        of_ball = earlier(std::move(of_ball), std::move(obstacle));
      }
      if (is_short_of_limit(*surface)) {
        break;
      }
    }
    if (first && way.length > 0.0 && !is_short_of_limit(*first)) {
      settle_limit(of_ball, ball, sweep, first->s);
    }
    broken = earlier(std::move(broken), std::move(of_ball));
  }
  const PartHit barred = first_hit(sweep, &MeshSweeper::first_contact_leaving, kBarredOnSkip);
  auto body = touch_of(rigid_, sweep);
  auto stem = touch_of(stem_, sweep);
  if (stem && stem->fraction >= pushed_from) {
    stem.reset();
  }
  auto ball = barred.part != nullptr
                  ? std::optional(obstacle_at(barred.fraction(), barred.hit, barred.part->name))
                  : std::nullopt;
  return earlier(earlier(std::move(body), std::move(stem)),
                 earlier(std::move(broken), std::move(ball)));
}

std::optional<machine::Obstacle> TouchProbe::touch_of(Sections sections,
                                                      const machine::Sweep& sweep,
                                                      double margin) const {
  const BallWay main = way_of(balls_.front(), sweep);
  const CentreWay way{main.p_M_from,   main.p_M_to,   margin,
                      sweep.tilt_from, sweep.tilt_to, Eigen::Quaterniond(R_MS_)};
  auto met = first_touch(sections, parts_->solids(), way);
  if (!met) {
    return std::nullopt;
  }
  const std::string& part = parts_->parts()[met->part].name;
  return machine::Obstacle{met->touch.fraction,
                           fmt::format("{} touches {}", met->section, part),
                           {met->touch.p_M_point, met->touch.n_M, part}};
}

std::optional<machine::Obstacle> TouchProbe::rigid_touch(const machine::Sweep& sweep) const {
  auto body = touch_of(rigid_, sweep);
  auto stem = touch_of(stem_, sweep);
  if (stem) {
    const double out = out_of_contact(sweep);
    if (out >= 1.0) {
      stem.reset();
    } else if (out > 0.0) {
      const AxisPositions q_M_out = sweep.q_M_from + out * (sweep.q_M_to - sweep.q_M_from);
      const Eigen::Quaterniond tilt_out = turn_between(sweep.tilt_from, sweep.tilt_to, out);
      stem = touch_of(stem_, {q_M_out, sweep.q_M_to, tilt_out, sweep.tilt_to});
      if (stem) {
        stem->fraction = out + (1.0 - out) * stem->fraction;
      }
    }
  }
  return earlier(std::move(body), std::move(stem));
}

double TouchProbe::out_of_contact(const machine::Sweep& sweep) const {
  const PartHit touch = first_hit(sweep, &MeshSweeper::sweep, kSensed);
  if (touch.part == nullptr || touch.hit.status != SweepStatus::StartInContact) {
    return 0.0;
  }
  const double out = touch.hit.n_M.dot(touch.way.along());
  const double depth = depth_of(touch);
  return out > depth ? std::max(0.0, depth / out) : 1.0;
}

std::optional<machine::Obstacle> TouchProbe::rigid_touch_on_curve(const machine::CurvedWay& curve,
                                                                  double begin, double end) const {
  if (parts_->solids().empty()) {
    return std::nullopt;
  }
  const machine::Sweep chord{curve.q_M_at(begin), curve.q_M_at(end)};
  const double share = end - begin;
  const double bulge = curve.bend * share * share / 8.0;
  if (bulge <= kSectionTouchErrorMm) {
    auto obstacle = rigid_touch(chord);
    if (obstacle) {
      obstacle->fraction = std::min(1.0, begin + obstacle->fraction * share);
    }
    return obstacle;
  }
  // Whether a stem in contact leaves it, only a chord that is as good as the curve can tell.
  if (!touch_of(rigid_, chord, bulge) && !touch_of(stem_, chord, bulge)) {
    return std::nullopt;
  }
  const double middle = begin + 0.5 * share;
  auto first = rigid_touch_on_curve(curve, begin, middle);
  return first ? first : rigid_touch_on_curve(curve, middle, end);
}

double TouchProbe::limit_of(const Tip& ball) const {
  return std::min(setup_.deflection_limit_mm, ball.radius);
}

std::optional<machine::Obstacle> TouchProbe::over_deflection(const Pressed& surface,
                                                             const Tip& ball,
                                                             const BallWay& way) const {
  if (way.length == 0.0) {
    return std::nullopt;
  }
  const double inwards = -surface.hit.n_M.dot(way.along()) / way.length;
  const double limit = limit_of(ball);
  if (inwards <= 0.0 || surface.depth + (way.length - surface.s) * inwards <= limit) {
    return std::nullopt;
  }
  const double broken_at = surface.s + std::max(0.0, limit - surface.depth) / inwards;
  auto obstacle = obstacle_at(broken_at / way.length, surface.hit, surface.part->name);
  obstacle.what = pushed_too_deep("stylus", limit, surface.part->name);
  return obstacle;
}

}  // namespace g31::probe

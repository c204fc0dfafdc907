#include "machine/sim/path_planner.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

/// Limits of ways in the same direction differ by rounding only.
constexpr double kSameLimit = 1e-9;

bool is_near(double a, double b) {
  return std::abs(a - b) <= kSameLimit * std::max(std::abs(a), std::abs(b));
}

bool are_alike(const PathLimits& a, const PathLimits& b) {
  return is_near(a.speed, b.speed) && is_near(a.acceleration, b.acceleration) &&
         is_near(a.jerk, b.jerk);
}

/// The way that a change of speed takes: the mean speed for its time.
double ramp_length(double from, double to, const PathLimits& limits) {
  return 0.5 * (from + to) * ramp_s(std::abs(to - from), limits);
}

/// With jerk: the root of a rising convex function lies below where it is positive, and Newton's
/// steps go down to it without passing it.
template <typename Function, typename Slope>
double root_below(double x, const Function& value, const Slope& slope) {
  constexpr int kMostSteps = 100;
  for (int i = 0; i < kMostSteps; ++i) {
    const double next = x - value(x) / slope(x);
    if (!(next < x)) {
      break;
    }
    x = next;
  }
  return std::max(0.0, x);
}

/// The highest speed between the ends of a span that is too short for its limit.
double highest_speed(double length, const PathLimits& limits, double from, double to) {
  const auto way = [&](double peak) {
    return ramp_length(from, peak, limits) + ramp_length(peak, to, limits);
  };
  if (limits.jerk == 0.0) {
    const double peak = std::sqrt(limits.acceleration * length + 0.5 * (from * from + to * to));
    return std::clamp(peak, std::max(from, to), limits.speed);
  }
  double low = std::max(from, to);
  double high = limits.speed;
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    (way(middle) <= length ? low : high) = middle;
  }
  return low;
}

/// The least reachable speed from any speed of a range.  Where jerk is limited, and each ramp ends
/// with the acceleration 0, braking to a little speed takes a longer way than to rest: the
/// reachable speed falls until a third of it (or half of what the full acceleration needs), then it
/// rises.
double least_reachable(double low, double high, double length, const PathLimits& limits) {
  if (limits.jerk == 0.0) {
    return reachable_speed(low, length, limits);
  }
  const double full = limits.acceleration * limits.acceleration / limits.jerk;
  const double without_full = std::cbrt(1.5 * limits.jerk * std::pow(0.75 * length, 2.0));
  const bool reaches_full = without_full > 1.5 * full;
  const double worst = reaches_full ? 0.5 * full : without_full / 3.0;
  return reachable_speed(std::clamp(worst, low, std::max(low, high)), length, limits);
}

void append_ramp(MotionPhases& phases, double from, double to, const PathLimits& limits) {
  const double change = to - from;
  const double sign = change < 0.0 ? -1.0 : 1.0;
  const double seconds = ramp_s(std::abs(change), limits);
  if (limits.jerk == 0.0) {
    phases.append(seconds, sign * limits.acceleration, 0.0);
    return;
  }
  const double jerk_s = std::min(limits.acceleration / limits.jerk, 0.5 * seconds);
  const double peak = sign * limits.jerk * jerk_s;
  phases.append(jerk_s, 0.0, sign * limits.jerk);
  phases.append(std::max(0.0, seconds - 2.0 * jerk_s), peak, 0.0);
  phases.append(jerk_s, peak, -sign * limits.jerk);
}

}  // namespace

[[gnu::hot]] double reachable_speed(double speed, double length, const PathLimits& limits) {
  const double most = limits.speed;
  if (speed >= most || ramp_length(speed, most, limits) <= length) {
    return most;
  }
  if (limits.jerk == 0.0) {
    return std::min(most, std::sqrt(speed * speed + 2.0 * limits.acceleration * length));
  }
  const double a = limits.acceleration;
  const double full = a * a / limits.jerk;
  if (ramp_length(speed, speed + full, limits) <= length) {
    // (2 u + D) (D + full) = 2 a L
    const double half = speed + 0.5 * full;
    const double rest = 2.0 * (a * length - speed * full);
    return std::min(most, speed + rest / (half + std::sqrt(half * half + rest)));
  }
  // (2 u + s^2) s = L sqrt(j), with D = s^2
  const double target = length * std::sqrt(limits.jerk);
  const double s = root_below(
      std::cbrt(target), [&](double x) { return (2.0 * speed + x * x) * x - target; },
      [&](double x) { return 2.0 * speed + 3.0 * x * x; });
  return std::min(most, speed + s * s);
}

[[gnu::hot]] SpanMotion::SpanMotion(double length, const PathLimits& limits, double from, double to)
    : length_(length), limits_(limits), from_(from), to_(to) {
  G31_EXPECTS(length > 0.0 && from >= 0.0 && to >= 0.0);
  if (from == 0.0 && to == 0.0) {
    profile_.emplace(length, limits.speed, limits.acceleration, limits.jerk);
    peak_ = profile_->peak_speed();
    duration_s_ = profile_->duration_s();
    return;
  }
  const auto ramps = [&](double peak) {
    return ramp_length(from, peak, limits) + ramp_length(peak, to, limits);
  };
  peak_ = ramps(limits.speed) <= length ? limits.speed : highest_speed(length, limits, from, to);
  cruise_s_ = std::max(0.0, length - ramps(peak_)) / peak_;
  duration_s_ = ramp_s(peak_ - from, limits) + ramp_s(peak_ - to, limits) + cruise_s_;
}

double SpanMotion::time_at(double distance) const {
  return profile_ ? profile_->time_at(distance) : phases().time_at(distance);
}

MotionPhases SpanMotion::phases() const {
  if (profile_) {
    return profile_->phases();
  }
  MotionPhases phases(MotionState{0.0, from_, 0.0});
  append_ramp(phases, from_, peak_, limits_);
  phases.append(cruise_s_, 0.0, 0.0);
  append_ramp(phases, peak_, to_, limits_);
  return phases;
}

[[gnu::hot]] void PathPlanner::add(double length, const PathLimits& limits, double corner_speed) {
  G31_EXPECTS(length > 0.0 && corner_speed >= 0.0 && limits.speed > 0.0);
  duration_s_.reset();
  double begin_speed = 0.0;
  if (!spans_.empty()) {
    Span& last = spans_.back();
    if (are_alike(last.limits, limits) && corner_speed >= last.limits.speed) {
      last.length += length;
      return;
    }
    begin_speed = std::min({corner_speed, last.limits.speed, limits.speed,
                            reachable_speed(last.begin_speed, last.length, last.limits)});
  }
  Span& next = spans_.emplace_back();  // a copy would wait for its parts
  next.length = length;
  next.limits = limits;
  next.begin_speed = begin_speed;
}

[[gnu::hot]] std::size_t PathPlanner::settled() const {
  double low = 0.0;
  double high = spans_.back().limits.speed;
  for (std::size_t i = spans_.size() - 1; i > 0; --i) {
    const Span& span = spans_[i];
    low = least_reachable(low, high, span.length, span.limits);
    high = span.begin_speed;
    if (low >= high) {
      return i;
    }
  }
  return 0;
}

[[gnu::hot]] void PathPlanner::plan(std::size_t count, double end_speed) const {
  speeds_.resize(count + 1);
  speeds_[count] = end_speed;
  for (std::size_t i = count; i > 0; --i) {
    const Span& span = spans_[i - 1];
    speeds_[i - 1] =
        std::min(span.begin_speed, reachable_speed(speeds_[i], span.length, span.limits));
  }
}

double PathPlanner::duration_s() const {
  if (!duration_s_) {
    plan(spans_.size(), 0.0);
    double seconds = 0.0;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const Span& span = spans_[i];
      seconds += SpanMotion(span.length, span.limits, speeds_[i], speeds_[i + 1]).duration_s();
    }
    duration_s_ = seconds;
  }
  return *duration_s_;
}

[[gnu::hot]] std::span<const SpanMotion> PathPlanner::release() {
  released_.clear();
  // Looking costs as much as a short block: every few spans will do, what is settled is the same.
  constexpr std::size_t kLeast = 8;
  constexpr std::size_t kLookEvery = 4;
  if (spans_.size() >= kLeast && spans_.size() % kLookEvery == 0) {
    if (const std::size_t count = settled(); count > 0) {
      give_out(count, spans_[count].begin_speed);
    }
  }
  return released_;
}

std::optional<PathPlanner::Cruise> PathPlanner::cruise() const {
  if (spans_.size() != 1) {
    return std::nullopt;
  }
  const Span& span = spans_.front();
  const double most = span.limits.speed;
  const Cruise cruise{ramp_length(span.begin_speed, most, span.limits),
                      span.length - ramp_length(most, 0.0, span.limits)};
  return cruise.from < cruise.until ? std::optional(cruise) : std::nullopt;
}

SpanMotion PathPlanner::give_out_beginning(double length, double rest) {
  G31_EXPECTS(spans_.size() == 1 && rest > 0.0);
  Span& span = spans_.front();
  SpanMotion beginning(length, span.limits, span.begin_speed, span.limits.speed);
  span.length = rest;
  span.begin_speed = span.limits.speed;
  duration_s_.reset();
  return beginning;
}

std::span<const SpanMotion> PathPlanner::finish() {
  released_.clear();
  give_out(spans_.size(), 0.0);
  return released_;
}

[[gnu::hot]] void PathPlanner::give_out(std::size_t count, double end_speed) {
  plan(count, end_speed);
  for (std::size_t i = 0; i < count; ++i) {
    const Span& span = spans_.front();
    released_.emplace_back(span.length, span.limits, speeds_[i], speeds_[i + 1]);
    spans_.pop_front();
  }
  duration_s_.reset();
}

}  // namespace g31::machine

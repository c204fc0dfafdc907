#include "machine/sim/skip_stop.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {

SkipStop stop_after_contact(const MotionProfile& profile, double contact_distance,
                            const SkipDelays& delays, Stopping stopping) {
  G31_EXPECTS(delays.latch_s >= 0.0 && std::isfinite(delays.latch_s));
  G31_EXPECTS(delays.stop_s >= 0.0 && std::isfinite(delays.stop_s));
  const double to_go = profile.length() - contact_distance;
  const double latch_s = profile.time_at(contact_distance) + delays.latch_s;
  const auto gone_at = [&](double time_s) {
    return std::clamp(profile.distance_at(time_s) - contact_distance, 0.0, to_go);
  };

  SkipStop stop;
  if (delays.latch_s > 0.0) {
    stop.latched_after = gone_at(latch_s);
  }
  stop.stopped_after = stop.latched_after;
  stop.duration_s = latch_s;
  if (stopping == Stopping::Ideal) {
    return stop;
  }
  const double brake_s = latch_s + delays.stop_s;
  if (profile.slows_down_at(brake_s)) {
    // Already braking, with the same deceleration: the end is where the axes come to rest.
    stop.stopped_after = to_go;
    stop.duration_s = std::max(latch_s, profile.duration_s());
  } else if (profile.has_limited_jerk()) {
    const MotionPhases braking = profile.phases_braking_at(brake_s);
    stop.stopped_after = std::clamp(braking.length() - contact_distance, stop.latched_after, to_go);
    stop.duration_s = braking.duration_s();
  } else {
    const double speed = profile.speed_at(brake_s);
    const double braking = speed * speed / (2.0 * profile.acceleration());
    const double begun = delays.stop_s > 0.0 ? gone_at(brake_s) : stop.latched_after;
    stop.stopped_after = std::min(begun + braking, to_go);
    stop.duration_s = brake_s + speed / profile.acceleration();
  }
  return stop;
}

Listening listening_of(const SkipMove& move, int input, const MotionProfile& profile) {
  constexpr double kPerMinute = 1.0 / 60.0;
  return {input, move.edge, std::min(kPerMinute * move.way.feed_mm_min, profile.peak_speed())};
}

}  // namespace g31::machine

#include "machine/sim/skip_stop.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {

SkipStop stop_after_contact(const MotionProfile& profile, double contact_distance, double delay_s,
                            Stopping stopping) {
  G31_EXPECTS(delay_s >= 0.0 && std::isfinite(delay_s));
  const double to_go = profile.length() - contact_distance;
  const double latch_s = profile.time_at(contact_distance) + delay_s;

  SkipStop stop;
  if (delay_s > 0.0) {
    stop.latched_after = std::clamp(profile.distance_at(latch_s) - contact_distance, 0.0, to_go);
  }
  stop.stopped_after = stop.latched_after;
  stop.duration_s = latch_s;
  if (stopping == Stopping::Ideal) {
    return stop;
  }
  if (profile.slows_down_at(latch_s)) {
    // Already braking, with the same deceleration: the end is where the axes come to rest.
    stop.stopped_after = to_go;
    stop.duration_s = std::max(latch_s, profile.duration_s());
  } else {
    const double speed = profile.speed_at(latch_s);
    const double braking = speed * speed / (2.0 * profile.acceleration());
    stop.stopped_after = std::min(stop.latched_after + braking, to_go);
    stop.duration_s = latch_s + speed / profile.acceleration();
  }
  return stop;
}

}  // namespace g31::machine

#include "machine/sim/motion_profile.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {

MotionProfile::MotionProfile(double length, double speed, double acceleration, double jerk)
    : length_(length), acceleration_(acceleration), jerk_(jerk) {
  G31_EXPECTS(length >= 0.0 && speed > 0.0 && acceleration > 0.0 && jerk >= 0.0);
  if (jerk > 0.0) {
    plan_with_jerk(speed);
    return;
  }
  const double full_ramp_length = speed * speed / (2.0 * acceleration);
  if (2.0 * full_ramp_length < length) {
    peak_speed_ = speed;
    ramp_s_ = speed / acceleration;
    ramp_length_ = full_ramp_length;
    duration_s_ = length / speed + ramp_s_;
  } else {
    ramp_s_ = std::sqrt(length / acceleration);
    peak_speed_ = acceleration * ramp_s_;
    ramp_length_ = 0.5 * length;
    duration_s_ = 2.0 * ramp_s_;
  }
}

void MotionProfile::plan_with_jerk(double speed) {
  const double a = acceleration_;
  const double full_acceleration_speed = a * a / jerk_;  // below it the acceleration only peaks
  const auto ramp_s = [&](double v) {
    return v >= full_acceleration_speed ? v / a + a / jerk_ : 2.0 * std::sqrt(v / jerk_);
  };
  peak_speed_ = speed;
  if (speed * ramp_s(speed) > length_) {
    // Two ramps are the whole way: v ramp_s(v) = length.
    peak_speed_ = std::cbrt(0.25 * length_ * length_ * jerk_);
    if (peak_speed_ > full_acceleration_speed) {
      const double jerk_s = a / jerk_;
      // The root of v^2/a + v a/j = length that does not cancel.
      peak_speed_ = 2.0 * length_ / (jerk_s + std::sqrt(jerk_s * jerk_s + 4.0 * length_ / a));
    }
  }
  ramp_s_ = ramp_s(peak_speed_);
  jerk_s_ = std::min(a / jerk_, 0.5 * ramp_s_);
  ramp_length_ = std::min(0.5 * peak_speed_ * ramp_s_, 0.5 * length_);
  const double cruise = length_ - 2.0 * ramp_length_;
  duration_s_ = 2.0 * ramp_s_ + (cruise > 0.0 ? cruise / peak_speed_ : 0.0);
}

double MotionProfile::ramp_distance(double time_s) const {
  if (jerk_ == 0.0) {
    return 0.5 * acceleration_ * time_s * time_s;
  }
  if (time_s <= jerk_s_) {
    return jerk_ * time_s * time_s * time_s / 6.0;
  }
  const double to_go_s = ramp_s_ - time_s;
  if (to_go_s <= jerk_s_) {
    return ramp_length_ - peak_speed_ * to_go_s + jerk_ * to_go_s * to_go_s * to_go_s / 6.0;
  }
  const double after_s = time_s - jerk_s_;
  const double begin = jerk_ * jerk_s_ * jerk_s_ * jerk_s_ / 6.0;
  return begin + jerk_ * jerk_s_ * after_s * (0.5 * jerk_s_ + 0.5 * after_s);
}

double MotionProfile::ramp_speed(double time_s) const {
  if (jerk_ == 0.0) {
    return acceleration_ * time_s;
  }
  if (time_s <= jerk_s_) {
    return 0.5 * jerk_ * time_s * time_s;
  }
  const double to_go_s = ramp_s_ - time_s;
  if (to_go_s <= jerk_s_) {
    return peak_speed_ - 0.5 * jerk_ * to_go_s * to_go_s;
  }
  return jerk_ * jerk_s_ * (0.5 * jerk_s_ + (time_s - jerk_s_));
}

double MotionProfile::ramp_time(double distance) const {
  if (jerk_ == 0.0) {
    return std::sqrt(2.0 * distance / acceleration_);
  }
  if (distance <= ramp_distance(jerk_s_)) {
    return std::cbrt(6.0 * distance / jerk_);
  }
  double low = jerk_s_;
  double high = ramp_s_;
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    (ramp_distance(middle) < distance ? low : high) = middle;
  }
  return high;
}

double MotionProfile::time_at(double distance) const {
  G31_EXPECTS(distance >= 0.0 && distance <= length_);
  if (distance <= ramp_length_) {
    return ramp_time(distance);
  }
  const double to_go = length_ - distance;
  if (to_go <= ramp_length_) {
    return duration_s_ - ramp_time(to_go);
  }
  return ramp_s_ + (distance - ramp_length_) / peak_speed_;
}

double MotionProfile::distance_at(double time_s) const {
  G31_EXPECTS(time_s >= 0.0);
  const double to_go_s = duration_s_ - time_s;
  if (to_go_s <= 0.0) {
    return length_;
  }
  if (time_s <= ramp_s_) {
    return ramp_distance(time_s);
  }
  if (to_go_s <= ramp_s_) {
    return length_ - ramp_distance(to_go_s);
  }
  return ramp_length_ + peak_speed_ * (time_s - ramp_s_);
}

double MotionProfile::speed_at(double time_s) const {
  G31_EXPECTS(time_s >= 0.0);
  const double to_go_s = duration_s_ - time_s;
  if (to_go_s <= 0.0) {
    return 0.0;
  }
  if (time_s <= ramp_s_) {
    return ramp_speed(time_s);
  }
  return to_go_s <= ramp_s_ ? ramp_speed(to_go_s) : peak_speed_;
}

MotionPhases MotionProfile::phases() const {
  const double cruise_s = std::max(0.0, duration_s_ - 2.0 * ramp_s_);
  const double full_s = std::max(0.0, ramp_s_ - 2.0 * jerk_s_);
  MotionPhases phases;
  if (jerk_ == 0.0) {
    phases.append(ramp_s_, acceleration_, 0.0);
    phases.append(cruise_s, 0.0, 0.0);
    phases.append(ramp_s_, -acceleration_, 0.0);
    return phases;
  }
  const double peak = jerk_ * jerk_s_;
  phases.append(jerk_s_, 0.0, jerk_);
  phases.append(full_s, peak, 0.0);
  phases.append(jerk_s_, peak, -jerk_);
  phases.append(cruise_s, 0.0, 0.0);
  phases.append(jerk_s_, 0.0, -jerk_);
  phases.append(full_s, -peak, 0.0);
  phases.append(jerk_s_, -peak, jerk_);
  return phases;
}

MotionPhases MotionProfile::phases_braking_at(double time_s) const {
  MotionPhases motion = phases();
  if (slows_down_at(time_s)) {
    return motion;
  }
  const MotionState now = motion.at(time_s);
  motion.cut_at(time_s);
  if (jerk_ == 0.0) {
    motion.append(now.speed / acceleration_, -acceleration_, 0.0);
    return motion;
  }
  // From the acceleration of now down to -peak, held there, and up to 0: the speed is used up.
  const double begun = now.acceleration * now.acceleration / (2.0 * jerk_);
  const double peak = std::min(acceleration_, std::sqrt(jerk_ * (now.speed + begun)));
  const double held_s = peak > 0.0 ? (now.speed + begun - peak * peak / jerk_) / peak : 0.0;
  motion.append((now.acceleration + peak) / jerk_, now.acceleration, -jerk_);
  motion.append(std::max(0.0, held_s), -peak, 0.0);
  motion.append(peak / jerk_, -peak, jerk_);
  return motion;
}

}  // namespace g31::machine

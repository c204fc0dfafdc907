#include "machine/sim/motion_profile.h"

#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {

MotionProfile::MotionProfile(double length, double speed, double acceleration)
    : length_(length), acceleration_(acceleration) {
  G31_EXPECTS(length >= 0.0 && speed > 0.0 && acceleration > 0.0);
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

double MotionProfile::time_at(double distance) const {
  G31_EXPECTS(distance >= 0.0 && distance <= length_);
  if (distance <= ramp_length_) {
    return std::sqrt(2.0 * distance / acceleration_);
  }
  const double to_go = length_ - distance;
  if (to_go <= ramp_length_) {
    return duration_s_ - std::sqrt(2.0 * to_go / acceleration_);
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
    return 0.5 * acceleration_ * time_s * time_s;
  }
  if (to_go_s <= ramp_s_) {
    return length_ - 0.5 * acceleration_ * to_go_s * to_go_s;
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
    return acceleration_ * time_s;
  }
  return to_go_s <= ramp_s_ ? acceleration_ * to_go_s : peak_speed_;
}

}  // namespace g31::machine

#pragma once

#include "machine/sim/motion_phases.h"

namespace g31::machine {

/// Speed over time along a path, from standstill to standstill: a trapezoid, or a triangle where
/// the path is too short to reach the speed.  Acceleration and deceleration are the same.  Where
/// jerk is limited, both have the shape of an S: seven phases in all.
///
/// Lengths are in path units, mm or deg (whichever the path is measured in), times in seconds.
/// Accuracy: times and distances within kMotionProfileError, relative to duration and length, of
/// a long double solution; within kJerkLimitedError where jerk is limited.
class MotionProfile {
 public:
  /// @param length        path units, >= 0; 0 takes no time
  /// @param speed         path units per second, > 0: never exceeded
  /// @param acceleration  path units per second squared, > 0
  /// @param jerk          path units per second cubed; 0 is without limit
  MotionProfile(double length, double speed, double acceleration, double jerk = 0.0);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double acceleration() const { return acceleration_; }
  [[nodiscard]] bool has_limited_jerk() const { return jerk_ > 0.0; }
  [[nodiscard]] double duration_s() const { return duration_s_; }

  /// The highest speed really reached; below the one asked for on a short path.
  [[nodiscard]] double peak_speed() const { return peak_speed_; }

  /// When the path has been travelled up to a distance.  @param distance 0..length()
  [[nodiscard]] double time_at(double distance) const;

  /// How far the path has been travelled.  @param time_s >= 0; from duration_s() on: length()
  [[nodiscard]] double distance_at(double time_s) const;

  /// Whether the deceleration towards the end has begun.  @param time_s >= 0
  [[nodiscard]] bool slows_down_at(double time_s) const { return time_s >= duration_s_ - ramp_s_; }

  /// The speed at a time.  @param time_s >= 0; from duration_s() on: 0
  [[nodiscard]] double speed_at(double time_s) const;

  /// The same motion, phase by phase.
  [[nodiscard]] MotionPhases phases() const;

  /// The motion when the control decides at a time to stop: as fast as acceleration and jerk
  /// allow; already slowing down, it goes on to its end.  @param time_s >= 0
  [[nodiscard]] MotionPhases phases_braking_at(double time_s) const;

 private:
  void plan_with_jerk(double speed);
  // The ramp up, counted from standstill; the ramp down is its mirror image.
  [[nodiscard]] double ramp_distance(double time_s) const;
  [[nodiscard]] double ramp_speed(double time_s) const;
  [[nodiscard]] double ramp_time(double distance) const;

  double length_;
  double acceleration_;
  double jerk_;          // 0: not limited
  double jerk_s_ = 0.0;  // how long the acceleration rises, and later falls again
  double peak_speed_;
  double ramp_s_;       // duration of the acceleration, and of the deceleration
  double ramp_length_;  // distance travelled during each of them
  double duration_s_;
};

/// Worst relative error seen over 20 000 profiles, times six; tests/machine/motion_profile_test.cc
/// holds it.
inline constexpr double kMotionProfileError = 2e-15;

/// The same with limited jerk.
inline constexpr double kJerkLimitedError = 1e-14;

}  // namespace g31::machine

#pragma once

#include <span>
#include <vector>

namespace g31::machine {

/// A piece of a motion along a path with constant jerk; path units (mm or deg) and seconds.
struct MotionPhase {
  double duration_s = 0.0;
  double jerk = 0.0;
  double distance = 0.0;  ///< at its beginning, as the next two
  double speed = 0.0;
  double acceleration = 0.0;

  /// A time 0..duration_s after the beginning.
  [[nodiscard]] double distance_after(double t) const {
    return distance + t * (speed + t * (acceleration / 2.0 + t * jerk / 6.0));
  }
  [[nodiscard]] double speed_after(double t) const {
    return speed + t * (acceleration + t * jerk / 2.0);
  }
  [[nodiscard]] double acceleration_after(double t) const { return acceleration + t * jerk; }
};

/// Distance, speed and acceleration at one time.
struct MotionState {
  double distance = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
};

/// A motion along a path in phases that follow each other without a step.
class MotionPhases {
 public:
  /// From standstill on.
  MotionPhases() = default;
  /// From a state on.
  explicit MotionPhases(const MotionState& start) : start_(start), end_(start) {}

  /// Goes on with a jerk.  A phase without duration is left out.  @param duration_s  >= 0
  void append(double duration_s, double jerk);

  /// Goes on with a jerk from a given acceleration: where jerk is not limited, the acceleration
  /// steps.
  void append(double duration_s, double acceleration, double jerk);

  /// The part between two times, its distance counted from its own beginning.
  [[nodiscard]] MotionPhases between(double from_s, double to_s) const;

  /// Leaves out what comes after a time.
  void cut_at(double time_s);

  [[nodiscard]] std::span<const MotionPhase> phases() const { return phases_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }

  /// The distance at the end.
  [[nodiscard]] double length() const { return end_.distance; }

  /// @param time_s  >= 0; from the duration on: the end
  [[nodiscard]] MotionState at(double time_s) const;

  /// When a distance is reached; the end for one that is not.  Speeds are never negative.
  [[nodiscard]] double time_at(double distance) const;

 private:
  std::vector<MotionPhase> phases_;
  double duration_s_ = 0.0;
  MotionState start_;
  MotionState end_;
};

}  // namespace g31::machine

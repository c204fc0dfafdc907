#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "machine/sim/motion_phases.h"
#include "machine/sim/motion_profile.h"

namespace g31::machine {

/// What is never exceeded along a path; path units (mm or deg) and seconds.
struct PathLimits {
  double speed = 0.0;         ///< > 0
  double acceleration = 0.0;  ///< > 0
  double jerk = 0.0;          ///< 0: not limited
};

/// The motion along a way with given speeds at both ends, the acceleration 0 there: up to the
/// highest speed that fits, and down again.  From rest to rest it is a MotionProfile, bit for bit.
class SpanMotion {
 public:
  /// @param from, to  speeds at the ends, such that the length allows to change from one to the
  ///                  other
  SpanMotion(double length, const PathLimits& limits, double from, double to);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] double peak_speed() const { return peak_; }
  /// When a distance 0..length() is reached.
  [[nodiscard]] double time_at(double distance) const;
  [[nodiscard]] MotionPhases phases() const;

 private:
  double length_;
  PathLimits limits_;
  double from_;
  double to_;
  double peak_ = 0.0;
  double cruise_s_ = 0.0;
  double duration_s_ = 0.0;
  std::optional<MotionProfile> profile_;  ///< from rest to rest
};

/// The speed along ways that follow each other, as a control plans it that knows them all: nowhere
/// above the limits of a way nor above the speed of a corner, and at rest at the end of the last
/// one.  Ways with the same limits and without a corner between them are one span.
///
/// Spans whose motion no further way can change are given out, so that little is kept.  Times hold
/// within kPathPlannerError, relative, of closed forms.
/// Source of the two passes: any look-ahead planner, such as LinuxCNC's; of the corner speed FANUC
/// A-63512EN, 3.
class PathPlanner {
 public:
  /// A way comes behind what is there.
  /// @param length        > 0
  /// @param corner_speed  >= 0: at its beginning; the first one begins at rest, whatever this says
  void add(double length, const PathLimits& limits, double corner_speed);

  [[nodiscard]] bool is_empty() const { return spans_.empty(); }

  /// s, from where the last span that was given out ended until the end of the last way, at rest.
  [[nodiscard]] double duration_s() const;

  /// The spans that nothing behind them changes any more, in order; they are forgotten here.  The
  /// result holds until the next call.
  std::span<const SpanMotion> release();

  /// Of one long span, at which of its lengths it goes at its highest speed whatever comes;
  /// nullopt: there is none, or more than one span.
  struct Cruise {
    double from = 0.0;
    double until = 0.0;
  };
  [[nodiscard]] std::optional<Cruise> cruise() const;
  /// Gives the beginning of that span out.
  /// @param length  in cruise()  @param rest  > 0: the length of what remains
  SpanMotion give_out_beginning(double length, double rest);

  /// All that is left, to the end at rest: the planner is as new.
  std::span<const SpanMotion> finish();

 private:
  struct Span {
    double length = 0.0;
    PathLimits limits;
    double begin_speed = 0.0;  ///< at most: the corner, and what the spans before allow
  };

  /// How many spans end with the highest speed that they can have, whatever comes behind the path.
  [[nodiscard]] std::size_t settled() const;
  /// The speeds of so many spans, backwards from that at their end.
  void plan(std::size_t count, double end_speed) const;
  void give_out(std::size_t count, double end_speed);

  std::deque<Span> spans_;
  mutable std::vector<double> speeds_;  ///< of the last plan(): at the beginnings and the end
  std::vector<SpanMotion> released_;
  mutable std::optional<double> duration_s_;
};

/// tests/machine/path_planner_test.cc holds it.
inline constexpr double kPathPlannerError = 1e-9;

/// How a change of speed goes: the time it takes.  @param change  >= 0
inline double ramp_s(double change, const PathLimits& limits) {
  if (limits.jerk == 0.0) {
    return change / limits.acceleration;
  }
  const double full = limits.acceleration * limits.acceleration / limits.jerk;
  return change >= full ? change / limits.acceleration + limits.acceleration / limits.jerk
                        : 2.0 * std::sqrt(change / limits.jerk);
}

/// The highest speed from which a way allows to brake to a speed, or to which it allows to
/// accelerate from it; limits.speed at most.
double reachable_speed(double speed, double length, const PathLimits& limits);

}  // namespace g31::machine

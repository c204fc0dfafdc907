#pragma once

#include <optional>

#include "machine/port/machine_port.h"
#include "machine/sim/arc_path.h"
#include "machine/sim/independent_path.h"
#include "machine/sim/led_path.h"
#include "machine/sim/machine_setup.h"
#include "machine/sim/motion_profile.h"
#include "machine/sim/path_planner.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {

/// How fast the axes may go, and what speed and acceleration a path has because of it.
class AxisDynamics {
 public:
  /// Rates and accelerations of the axes that are present must be > 0.
  explicit AxisDynamics(const MachineSetup& setup);

  /// @param per_s3  for each axis from now on; 0: not limited
  void set_jerks(const AxisPositions& per_s3);
  [[nodiscard]] AxisPositions jerks() const;

  /// @param per_s  for each axis from now on; < 0: what the machine has
  void set_corner_jumps(const AxisPositions& per_s);

  /// The motion of a move along a path: all axes start and end together.
  ///
  /// A rapid goes as fast as the slowest axis allows; a feed goes with move.feed_mm_min along
  /// path.length(), but no faster than that: a control, too, clamps a feed that an axis cannot
  /// follow.  Acceleration and jerk are the greatest at which no axis exceeds its own, with
  /// look-ahead the one for contours; the jerk where the move limits it.
  /// @param path  path.moves(); only axes that are present move
  [[nodiscard]] PathLimits limits(const StraightPath& path, const LinearMove& move) const;
  [[nodiscard]] MotionProfile profile(const StraightPath& path, const LinearMove& move) const;

  /// The way of a move on which each axis goes on its own, with its rapid rate, acceleration and
  /// jerk; nullopt: the way is straight, by what the move says or because one axis alone moves.
  /// @param straight  of that move; only axes that are present move
  [[nodiscard]] std::optional<IndependentPath> independent_path(const StraightPath& straight,
                                                                const LinearMove& move) const;

  /// The motion along an arc: the feed, clamped so that no axis of the plane exceeds its rapid rate
  /// in any direction, no helix axis its own, and no axis its acceleration.  Half of what the plane
  /// can give (in squares) goes along the arc, half towards the centre, so that braking in a
  /// bend is always possible.
  /// @param path  path.length() > 0; only axes that are present move
  /// @param feed_mm_min  > 0, along path.length()
  [[nodiscard]] PathLimits limits(const ArcPath& path, double feed_mm_min,
                                  ContourControl contour_control = ContourControl::Off,
                                  const Smoothness& smoothness = {}) const;
  [[nodiscard]] MotionProfile profile(const ArcPath& path, double feed_mm_min) const;

  /// The motion along a led way: the feed, or for a rapid the fastest there is, so slow that in no
  /// piece of the way an axis exceeds its rapid rate, nor half its acceleration by the bend of the
  /// way; the other half is for the speed along it.
  /// @param path  path.length() > 0; only axes that are present move
  [[nodiscard]] PathLimits limits(const LedPath& path, const LinearMove& move) const;

  /// The speed of a corner between two ways that pass on into each other: no axis changes its speed
  /// there by more than its corner_jump, or what its acceleration makes in kCornerS.  Infinite
  /// where the direction stays, within kSameDirection. Source of the rule, with a parameter for
  /// each axis: FANUC A-63512EN, 3.
  /// @param along_before, along_behind  what each axis goes in a unit of the path
  [[nodiscard]] double corner_speed(const AxisPositions& along_before,
                                    const AxisPositions& along_behind) const;

  /// The speed of a curve in the place of such a corner: sqrt(a R) of an arc that leaves the corner
  /// by at most a tolerance and begins and ends no farther than half of either way from it; a is
  /// the greatest acceleration at which no axis exceeds its own one for contours anywhere on the
  /// arc.
  /// @param along_before, along_behind  what each axis goes in a unit of the path
  /// @param most  tolerance and half length, path units, both > 0
  struct CornerCurve {
    double tolerance = 0.0;
    double half_length = 0.0;
  };
  [[nodiscard]] double curve_speed(const AxisPositions& along_before,
                                   const AxisPositions& along_behind,
                                   const CornerCurve& most) const;

 private:
  [[nodiscard]] const AxisPositions& accelerations(ContourControl contour_control) const {
    return contour_control == ContourControl::Off ? acceleration_per_s2_
                                                  : contour_acceleration_per_s2_;
  }
  /// The greatest jerk along a path at which no axis exceeds its own; 0: none limits it.
  [[nodiscard]] double jerk_along(double length, const AxisPositions& way) const;
  [[nodiscard]] double jerk_on(const ArcPath& path, const AxisPositions& helix) const;

  AxisPositions rapid_per_s_;
  AxisPositions acceleration_per_s2_;
  AxisPositions contour_acceleration_per_s2_;
  AxisPositions corner_jump_per_s_;
  AxisPositions own_corner_jump_per_s_;
  AxisPositions jerk_per_s3_;  // infinite: not limited
  bool limits_jerk_ = false;
};

/// So sharp corners almost stop, and the chords of a fine polygon do not.
inline constexpr double kCornerS = 0.001;

/// Unit directions nearer than this are one: they differ by rounding.
inline constexpr double kSameDirection = 1e-9;

}  // namespace g31::machine

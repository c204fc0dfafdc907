#pragma once

#include "machine/port/machine_port.h"
#include "machine/port/surroundings.h"
#include "machine/sim/axis_dynamics.h"
#include "machine/sim/clock.h"
#include "machine/sim/machine_setup.h"
#include "machine/sim/travel_limits.h"

namespace g31::machine {

/// The simulated machine tool: axes with travel limits, acceleration and time, in a world that
/// may raise the skip signal or be in the way.
///
/// Every move begins and ends at standstill (exact stop).  Ends that are not finite, and feeds
/// that are not > 0, are the caller's bug and stop the process.  A soft limit is checked at the
/// end point before anything moves; leaving a place outside the limits is allowed.
class MachiningCentre final : public MachinePort {
 public:
  /// @param surroundings  the world around the tool; null: empty, nothing is ever touched.
  ///                      Not owned: it must outlive the machine.
  MachiningCentre(const MachineSetup& setup, Surroundings* surroundings);

  /// Moves to the end, exactly (bit for bit).  Faults: SoftLimit, nothing moved; Collision, the
  /// axes stand at the obstacle.  A move without a way to go takes no time and asks nobody.
  Result<AxisPositions, MachineFault> move(const LinearMove& move) override;

  /// Moves along the arc to the end, exactly.  Faults as above; the travel limits are checked on
  /// the whole arc.  The surroundings are asked chord by chord (see ArcPath::chord_count).
  Result<AxisPositions, MachineFault> move(const ArcMove& arc) override;

  /// Moves until the skip signal.  From the contact the axes go on for the trigger's delay along
  /// the commanded motion, then the position is latched and the axes stop as MachineSetup says;
  /// neither point lies beyond the programmed end.  The overtravel past the contact meets no
  /// obstacle: the stylus gives way.
  ///
  /// Faults: SoftLimit only.  A move without a way to go is NoTouch and asks nobody.
  /// Accuracy: with Stopping::Ideal and no delay the latched position is the point of contact
  /// within kSkipPositionErrorMm.
  Result<SkipOutcome, MachineFault> move_until_skip(const LinearMove& move) override;

  /// Takes no time; the surroundings turn what is in the spindle.
  void orient_spindle(double angle_deg) override;
  void dwell(double seconds) override;
  [[nodiscard]] AxisPositions position() const override { return q_M_; }
  [[nodiscard]] double time_s() const override { return clock_.now_s(); }

 private:
  [[nodiscard]] MachineFault soft_limit_fault(const AxisPositions& q_M_end) const;
  MachineFault stop_at(Obstacle obstacle, const AxisPositions& q_M_stop, double seconds);
  std::optional<MachineFault> collide_on(const ArcPath& path, const MotionProfile& profile);
  SkipOutcome stop_for(SkipTrigger trigger, const StraightPath& path, const MotionProfile& profile);

  TravelLimits limits_;
  AxisDynamics dynamics_;
  Stopping stopping_;
  Surroundings* surroundings_;
  Clock clock_;
  AxisPositions q_M_;
};

/// For coordinates within 1000 mm, five times the worst error seen over 20 000 skip moves along one
/// axis; tests/machine/machining_centre_skip_test.cc holds it.
inline constexpr double kSkipPositionErrorMm = 1e-12;

}  // namespace g31::machine

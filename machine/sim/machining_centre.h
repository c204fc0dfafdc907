#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "machine/port/machine_port.h"
#include "machine/port/surroundings.h"
#include "machine/sim/axis_dynamics.h"
#include "machine/sim/clock.h"
#include "machine/sim/continuous_path.h"
#include "machine/sim/led_path.h"
#include "machine/sim/machine_setup.h"
#include "machine/sim/motion_listener.h"
#include "machine/sim/motion_sampler.h"
#include "machine/sim/real_axes.h"
#include "machine/sim/travel_limits.h"

namespace g31::machine {

/// The simulated machine tool: axes with travel limits, acceleration and time, in a world that
/// may raise the skip signal or be in the way.
///
/// Moves at feed that pass on go into each other: planned ahead (ContinuousPath), or, where axes
/// lag and no contour control is on, each at its own feed from its beginning to its end, which the
/// lag smooths.  All others begin and end at standstill.  The way of axes that lag or stick depends
/// on the plan: what is in it is met when it is carried out, moves later.  Ends that are not
/// finite, and feeds that are not > 0, are the caller's bug and stop the process.  A soft limit is
/// checked at the end point before anything moves; leaving a place outside the limits is allowed.
///
/// Positions that go in and come out are the encoders' at rest.  The world is asked about the true
/// ones (RealAxes): behind the command by the servo lag, off by the errors of the machine, on a
/// table that turns.  On an ideal machine all of these are the same, bit for bit.  What is latched
/// or stopped at is a whole number of steps of the encoder.
class MachiningCentre final : public MachinePort {
 public:
  /// @param surroundings  the world around the tool; null: empty, nothing is ever touched.
  ///                      Not owned: it must outlive the machine.
  MachiningCentre(const MachineSetup& setup, Surroundings* surroundings);

  /// Moves to the end, exactly (bit for bit).  Faults: SoftLimit, nothing moved; Collision, the
  /// axes stand at the obstacle.  A move without a way to go takes no time and asks nobody.
  Result<AxisPositions, MachineFault> move(const LinearMove& move) override;

  /// Moves along the arc to the end, exactly.  Faults as above; the travel limits are checked on
  /// the whole arc.  The surroundings are asked about it as a curve.
  Result<AxisPositions, MachineFault> move(const ArcMove& arc) override;

  /// Moves until the skip signal, along the curve where a transformation leads the axes and rotary
  /// ones turn.  From the contact the axes go on for the trigger's delay along
  /// the commanded motion, then the position is latched and the axes stop as MachineSetup says;
  /// neither point lies beyond the programmed end.  The overtravel past the contact meets no
  /// obstacle: the stylus gives way.  A move that listens to an input without a probe goes to its
  /// end.
  ///
  /// Faults: SoftLimit only.  A move without a way to go is NoTouch and asks nobody.
  /// Accuracy: with Stopping::Ideal and no delay the latched position is the point of contact
  /// within kSkipPositionErrorMm.
  Result<SkipOutcome, MachineFault> move_until_skip(const SkipMove& move) override;

  [[nodiscard]] bool skip_signal(int input) const override;
  [[nodiscard]] std::optional<SensorState> sensor_state(int input) const override;
  [[nodiscard]] std::optional<bool> digital_input(int number) const override;
  [[nodiscard]] std::optional<double> displacement(int input) const override;

  // What the surroundings make of these decides; nothing moves.
  void change_tool(const ToolChange& change) override;
  void turn_spindle(const SpindleTurn& turn) override;
  void auxiliary_code(const AuxiliaryCode& code) override;
  void digital_output(const DigitalOutput& output) override;
  void dwell(double seconds) override;
  void stand_still() override;
  void come_to_rest() override;
  [[nodiscard]] AxisData axis_data() const override { return axis_data_; }
  void set_axis_data(const AxisData& data) override;
  void compensate(const std::vector<CompensationTable>& tables) override;
  MaybeFault take_late_fault() override;
  [[nodiscard]] std::optional<AxisTravel> travel(int axis) const override {
    return limits_.of(axis);
  }
  [[nodiscard]] std::string stands_inside() const override;
  [[nodiscard]] AxisPositions position() const override { return q_M_; }
  /// As if the axes came to rest at the end of the last move.
  [[nodiscard]] double time_s() const override;

  /// Is looked at in the middle of long work from now on.  @param watch  outlives this; where it
  /// throws, nothing is to move any more
  void watch(WorkWatch& watch) { real_.watch(watch); }

  /// Takes samples of all motion from now on.  @param sink  outlives this
  void trace(double period_s, TraceSink& sink);
  /// Takes a last sample, of where all motion has ended.
  void end_trace();
  /// Tells of all motion from now on.  @param listener  outlives all motion
  void tell_motions_to(MotionListener& listener);

 private:
  static void expect_legal(const LinearMove& move);
  static void expect_legal(const ArcMove& arc);
  static bool is_fraction(double number);
  void tell(const MachineEvent& event);
  void tell_time() const;
  void arrive(const AxisPositions& q_M_end, const MoveTag& tag) {
    q_M_ = q_M_end;
    followed_ = tag;
  }
  // A fault of axes that still follow it is that of the last move.
  void find_late(MaybeFault fault);
  /// What the way that a skip move took, of axes and tool tip, has broken.
  MaybeFault damage(const RealAxes::Encoders& went, const Waypoint& tip_from);
  Result<SkipOutcome, MachineFault> skip_led(const LedPath& path, const SkipMove& move);
  [[nodiscard, gnu::cold]] MachineFault soft_limit_fault(const AxisPositions& q_M_end) const;
  Result<AxisPositions, MachineFault> move_led(const LedPath& path, const LinearMove& move);
  [[nodiscard]] MaybeFault fault_on(const LedPath& path) const;
  [[gnu::cold]] MachineFault stop_at(Obstacle obstacle, const AxisPositions& q_M_stop,
                                     double seconds);
  std::optional<Obstacle> obstacle_on(const StraightPath& path, Travel travel);
  template <typename Curve>
  std::optional<Obstacle> obstacle_on(const Curve& path, Travel travel);

  // All the way along, or until something is in it.
  MaybeFault carry_out(const StraightPath& path, const LinearMove& move);
  template <typename Path, typename Profile>
  MaybeFault carry_out(const Path& path, const Profile& profile, const Carriage& how);
  template <typename Path, typename Profile>
  MaybeFault carry_out_ideally(const Path& path, const Profile& profile, const Carriage& how);
  MaybeFault carry_out_really(const ServoMotion& motion, const Carriage& how);
  MaybeFault break_off(const ServoMotion& motion, Timed<Obstacle> obstacle);
  // What lags comes to its place while the program waits.
  MaybeFault wait_really(double seconds);

  template <typename Path>
  MaybeFault feed(const Path& path, const PathLimits& limits, const Passing& passing);
  // A move that the one before may have passed on into, and that may pass on itself.
  [[nodiscard]] bool joins(const Passing& passing) const;
  [[nodiscard]] bool passes_on(const LinearMove& rapid) const;
  template <typename Path>
  MaybeFault pass_on(const Path& path, const PathLimits& limits, const Passing& passing);
  MaybeFault keep_feed(const CommandedPath& path, const MotionPhases& phases, BlockEnd ends);
  template <typename Path>
  std::optional<Obstacle> obstacle_in_passing(const Path& path, const PathLimits& limits);
  void pass(const ContinuousPath::Passed& passed);
  void travel_late(const Travelled& way);
  [[nodiscard]] double speed_at_corner(const ContinuousPath::Move& behind,
                                       const AxisPositions& along_start) const;
  void settle(const AxisPositions& q_M_end, BlockEnd ends);
  // The ways of axes that do not follow at once are carried out as they are planned.
  void keep_what_follows();
  // Moves that pass on do so no further; a command that is smoothed has not come to rest.
  void end_passing();

  // Until the signal; nullopt: there is none.
  std::optional<SkipOutcome> skip(const StraightPath& path, const MotionProfile& profile,
                                  const SkipMove& move);
  // What the world says to a way that the axes go as commanded.
  [[nodiscard]] std::optional<SkipTrigger> first_signal(const StraightPath& path,
                                                        const MotionProfile& profile,
                                                        Listening to) const;
  std::optional<SkipOutcome> skip_really(const CommandedPath& path, const MotionProfile& profile,
                                         const SkipMove& move);
  SkipOutcome stop_for(SkipTrigger trigger, const StraightPath& path, const MotionProfile& profile,
                       AfterSignal after);
  // Until the later one of two signals.
  SkipOutcome skip_for_both(const StraightPath& path, const SkipMove& move);
  SkipOutcome stop_for_both(std::array<std::optional<Timed<SkipTrigger>>, 2> signals,
                            const StraightPath& path, const SkipMove& move);
  void go_without_signal(const AxisPositions& q_M_end, const SkipMove& move);
  SkipOutcome stop_really(Timed<SkipTrigger> trigger, const CommandedPath& path,
                          const MotionProfile& profile, const SkipMove& move);

  // Whether somebody wants to know how the axes go, not only where to.
  [[nodiscard]] bool is_watched() const { return sampler_ || listener_ != nullptr; }
  void show(const ExecutedMotion& motion);
  // An ideal motion, from now on.
  void show(const CommandedPath& path, const MotionPhases& phases, double duration_s);
  // A motion of real axes: they, the clock and whoever watches follow it.
  void follow(const ServoMotion& motion, double duration_s);

  TravelLimits limits_;
  AxisDynamics dynamics_;
  Stopping stopping_;
  double stop_delay_s_;
  std::vector<InputWire> wires_;
  Surroundings* surroundings_;
  Clock clock_;
  ContinuousPath continuous_;
  bool keeps_feed_ = false;  // the last move did, and nothing has happened since
  MaybeFault late_;          // of a move that passed on, until somebody can be told
  // Of the move that axes which lag follow while the program waits; a skip move has none.
  std::optional<MoveTag> followed_;
  mutable double told_s_ = 0.0;  // the last time that the surroundings were told
  AxisPositions q_M_;
  AxisPositions resolution_;  // of the encoders; 0: no steps
  RealAxes real_;
  AxisData axis_data_;
  std::optional<MotionSampler> sampler_;
  MotionListener* listener_ = nullptr;
};

/// For coordinates within 1000 mm, five times the worst error seen over 20 000 skip moves along one
/// axis; tests/machine/machining_centre_skip_test.cc holds it.
inline constexpr double kSkipPositionErrorMm = 1e-12;

}  // namespace g31::machine

#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "machine/port/skip_signal.h"
#include "machine/units/point.h"
#include "probe/collision/probe_section.h"

namespace g31::probe {

enum class ProbeType {
  ThreeD,  ///< gives a signal whatever side is touched
  Mono,    ///< in one direction sideways, and from above
};

/// What holds the stylus, and so in which directions it gives way more easily.
enum class Seats {
  Even,    ///< the same force all around (strain gauges)
  Tripod,  ///< three seats 120 degrees apart: three weak and three strong directions
};

/// What is the matter with a probe.
enum class ProbeState {
  Ready,
  Dead,           ///< never gives a signal
  LowBattery,     ///< works, and says so
  DoubleTrigger,  ///< each touch gives two signals; the control latches the first
};

struct ProbeStateName {
  ProbeState state;
  std::string_view name;
};

/// What set-up sheets and documents call the states.
inline constexpr std::array<ProbeStateName, 4> kProbeStateNames = {{
    {ProbeState::Ready, "ready"},
    {ProbeState::Dead, "dead"},
    {ProbeState::LowBattery, "low_battery"},
    {ProbeState::DoubleTrigger, "double_trigger"},
}};

/// How far the stylus gives way until the probe gives its signal.
///
/// Directions are those of the probe's motion, degrees from +X towards +Y at spindle angle 0; they
/// turn with the spindle.
struct SwitchSetup {
  ProbeType type = ProbeType::ThreeD;
  double mono_direction_deg = 0.0;  ///< of a mono probe: the direction that gives a signal
  double pre_travel_mm = 0.0;       ///< >= 0, along the surface normal, in all directions
  Seats seats = Seats::Even;
  double weak_direction_deg = 0.0;  ///< of a tripod: one of its three weakest directions
  double trigger_force_n = 0.0;     ///< >= 0, sideways at the ball, in the weakest direction
  double axial_force_n = 5.0;       ///< > 0, along the stylus
  double stem_stiffness_n_mm =
      std::numeric_limits<double>::infinity();  ///< > 0, sideways, at the ball
};

/// A further ball of an L or star stylus.
struct StylusBall {
  Point p_S_from_main = Point::Zero();  ///< mm, from the main ball at spindle angle 0
  double diameter_mm = 6.0;             ///< > 0
};

/// What of a program switches something.
struct ProgramSwitch {
  enum class Kind {
    Code,   ///< an M code
    Output  ///< a digital output that becomes 1
  };
  Kind kind = Kind::Code;
  int number = 0;

  bool operator==(const ProgramSwitch&) const = default;
};

/// How a probe gets into the spindle and is switched.  Without any of it, it is there and on.
struct SwitchingSetup {
  std::optional<int> tool;           ///< the number that it is; the spindle holds it at the start
  std::vector<int> other_tools;      ///< without a number of its own it is all but these
  std::optional<ProgramSwitch> on;   ///< with one it is off at the start
  std::optional<ProgramSwitch> off;  ///< the same code as on does both turn by turn
  double start_up_s = 0.0;           ///< >= 0, from being switched on until it can give a signal
  bool may_turn = false;             ///< nothing is said of measuring while the spindle turns

  /// Whether programs bring the probe or switch it on, and so can forget to.
  [[nodiscard]] bool is_up_to_program() const { return tool || on || !other_tools.empty(); }
};

/// What the set-up sheet says about the touch probe.  Lengths in mm.
struct ProbeSetup {
  double ball_diameter_mm = 6.0;  ///< > 0
  double length_mm = 120.0;       ///< spindle gauge line to ball centre, along -Z of the machine
  std::array<double, 2> eccentricity_mm = {0.0, 0.0};  ///< ball centre off the spindle axis, X Y
  bool in_turret = false;                              ///< no spindle turns it
  /// Of the stylus from +Z, which leads from the ball to what holds it; other than none in a turret
  /// only.
  Eigen::Quaterniond turn_of_stylus = Eigen::Quaterniond::Identity();
  double trigger_delay_s = 0.0;                  ///< >= 0
  std::optional<double> calibrated_feed_mm_min;  ///< > 0: what programs take off was found at it
  double repeatability_mm = 0.0;   ///< standard deviation of the trigger point along the move
  int input = machine::kAnyInput;  ///< measuring input that it is wired to; kAnyInput: all of them
  SwitchingSetup switching;
  SwitchSetup at_switch;
  std::vector<StylusBall> further_balls;
  double deflection_limit_mm = std::numeric_limits<double>::infinity();  ///< > 0, see TouchProbe
  /// What must never touch, in places above the main ball.  The stem gives way with the ball when
  /// that is pushed in; the bodies do not.
  std::vector<ProbeSection> stem;
  std::vector<ProbeSection> bodies;
  ProbeState state = ProbeState::Ready;
};

/// The probe of a second spindle beside the first, on the same axes; it turns, comes and goes as
/// the first one.
struct SecondProbeSetup {
  ProbeSetup probe;
  Point p_T_beside = Point::Zero();  ///< mm, from the first spindle to the second
};

/// One `[[skip_signal]]` of the set-up sheet: the signal of one skip move, without a probe.
struct SkipSignal {
  int axis = 0;              ///< storage index: 0 X, 1 Y, 2 Z...
  std::optional<double> at;  ///< machine coordinate that raises the signal; none: no signal
};

}  // namespace g31::probe

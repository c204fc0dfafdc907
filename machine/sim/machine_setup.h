#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "machine/errors/axis_play.h"
#include "machine/errors/cyclic_error.h"
#include "machine/errors/geometric_errors.h"
#include "machine/kinematics/axis_chain.h"
#include "machine/port/machine_port.h"
#include "machine/sim/velocity_loop.h"
#include "machine/units/axis_positions.h"
#include "machine/units/thermal_growth.h"

namespace g31::machine {

/// A servo gain of 1 (m/min)/mm is a time constant of 60 ms.
inline constexpr double kSecondsAtGainOne = 0.06;

/// The coarse window of an exact stop, as controls are delivered, as a multiple of the fine one.
inline constexpr double kCoarsePerFine = 4.0;

/// One axis of the simulated machine; mm, s for linear axes, deg, s for rotary ones.
struct AxisSetup {
  bool present = false;
  double travel_min = -std::numeric_limits<double>::infinity();  ///< soft limit, machine coordinate
  double travel_max = std::numeric_limits<double>::infinity();
  double rapid_per_min = 20000.0;       ///< mm/min or deg/min, > 0
  double acceleration_per_s2 = 2000.0;  ///< mm/s^2 or deg/s^2, > 0
  double jerk_per_s3 = 0.0;             ///< mm/s^3 or deg/s^3; 0: not limited
  double servo_gain = 0.0;              ///< Kv, (m/min)/mm or (1000 deg/min)/deg; 0: without lag
  double feed_forward = 0.0;            ///< 0..1: share of the command's speed, where it is on
  double contour_acceleration_per_s2 = 0.0;   ///< with look-ahead; 0: acceleration_per_s2
  std::optional<double> corner_jump_per_min;  ///< >= 0; none: acceleration_per_s2 times 1 ms
  VelocityLoopSetup velocity_loop;            ///< behind the position loop
  double home = 0.0;                          ///< reference point, machine coordinate
  double scale_resolution = 0.0;          ///< mm or deg, >= 0: one step of the encoder; 0: no steps
  errors::PlaySetup play;                 ///< what a reversal does
  errors::CyclicErrorSetup cyclic_error;  ///< of screw or scale
  ThermalGrowth scale_growth;             ///< of the scale, linear axes only
  double scale_fixed_at = 0.0;            ///< machine coordinate where a growing scale stays
};

/// How the axes come to rest when the control latches the skip signal.
enum class Stopping {
  Braking,  ///< with the acceleration of the path, from the latch on
  Ideal,    ///< at the latch, in no time: no overtravel, no servo lag
};

/// X, Y and Z without travel limits.  A function, not a lambda in the initialiser below: there g++
/// 12 leaves the last elements zero.
inline std::array<AxisSetup, kAxisCount> three_linear_axes() {
  std::array<AxisSetup, kAxisCount> axes;
  axes.fill(AxisSetup{});
  for (int i = 0; i < kLinearAxisCount; ++i) {
    axes[static_cast<std::size_t>(i)].present = true;
  }
  return axes;
}

/// A digital input that programs read, and what in the machine sets it.
struct InputWire {
  enum class Source {
    Ready,  ///< what is at the measuring input can give its signal
    Signal  ///< it gives it
  };
  int number = 0;  ///< as programs count digital inputs
  Source source = Source::Ready;
  int measuring_input = kAnyInput;
};

/// What the set-up sheet says about the machine.  The default is an ideal three-axis machine
/// without travel limits.
struct MachineSetup {
  std::string name = "ideal three-axis machine";
  std::array<AxisSetup, kAxisCount> axes = three_linear_axes();
  AxisPositions q_M_start = AxisPositions::Zero();
  Stopping stopping = Stopping::Braking;
  double stop_delay_s = 0.0;  ///< >= 0, from the skip signal until the axes begin to brake
  double in_position = 0.01;  ///< mm or deg, > 0: so near an exact stop takes the axes as arrived
  AxisChainSetup chain;
  errors::GeometricErrorSetup geometric_errors;
  errors::GeometricErrorSetup compensation;  ///< what the control adds, of the linear directions
  Point p_T_tip = Point::Zero();  ///< mm, from the spindle's gauge point: what angular errors move
  std::vector<InputWire> wires;
};

}  // namespace g31::machine

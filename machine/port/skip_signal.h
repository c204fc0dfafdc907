#pragma once

#include <functional>
#include <optional>

#include "machine/units/axis_positions.h"

namespace g31::machine {

/// Which change of the skip signal counts.
enum class SignalEdge {
  Rising,  ///< the stylus is deflected
  Falling  ///< it comes free
};

inline constexpr int kAnyInput = 0;

/// What a move listens to.
struct Listening {
  int input = kAnyInput;  ///< measuring input, from 1
  SignalEdge edge = SignalEdge::Rising;
  double speed_mm_s = 0.0;  ///< at which the way is travelled; what turns meanwhile depends on it
  /// When a fraction 0..1 of the way is reached, s after its beginning; empty: at that speed
  /// throughout.
  std::function<double(double)> time_s_at = {};
  /// Where the axes truly are at a fraction 0..1 of the way; empty: no rotary axis is in the chain,
  /// and the way's own positions are theirs.
  std::function<AxisPositions(double)> axes_at = {};
};

/// How what gives the signal of an input is placed to do so.
struct SensorState {
  bool in_place = true;     ///< the tool that carries it is where it belongs
  bool switched_on = true;  ///< as far as programs switch it
  bool stands = true;       ///< its spindle, or those of parts before a turret, do not turn
  /// The spindle stands where a program put it, or that makes no difference.
  bool angle_known = true;
  bool works = true;  ///< it is not broken
  double ball_radius_mm = 0.0;
  double delay_s = 0.0;                               ///< from the touch to the signal
  std::optional<double> calibrated_feed_mm_min = {};  ///< at which the delay was taken off

  [[nodiscard]] bool is_ready() const { return in_place && switched_on && works; }
  bool operator==(const SensorState&) const = default;
};

}  // namespace g31::machine

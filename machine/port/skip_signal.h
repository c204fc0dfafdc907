#pragma once

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
};

/// How what gives the signal of an input is placed to do so.
enum class SensorState {
  Ready,
  Turning,      ///< the spindle that holds it turns
  Dead,         ///< broken: it never gives a signal
  SwitchedOff,  ///< the program has not switched it on
  NotInPlace,   ///< another tool, or none, is where it belongs
};

}  // namespace g31::machine

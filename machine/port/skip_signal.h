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

}  // namespace g31::machine

#pragma once

#include <optional>
#include <variant>

namespace g31::machine {

enum class Rotation {
  Stopped,           ///< M5
  Clockwise,         ///< M3, seen from the spindle towards the tool
  Counterclockwise,  ///< M4
};

/// What a program has a spindle do.
struct SpindleTurn {
  Rotation rotation = Rotation::Stopped;
  double speed_rev_min = 0.0;       ///< >= 0; 0 as long as no speed was programmed
  std::optional<double> angle_deg;  ///< stands at this angle (M19, SPOS): with Stopped only
  int spindle = 1;
};

/// What a program tells a machine to do that is no motion.
using MachineEvent = std::variant<SpindleTurn>;

}  // namespace g31::machine

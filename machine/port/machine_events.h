#pragma once

#include <array>
#include <optional>
#include <variant>

namespace g31::machine {

/// A tool as the control that calls it believes it to be.
struct Tool {
  /// Of a tool of a lathe, whose edge does not turn.
  struct Edge {
    std::array<double, 3> lengths_mm = {};  ///< along X, Z and Y: tool reference point less tip
    int position = 9;  ///< 1 to 9 as SINUMERIK counts; 9: the tip is the middle
  };
  int number = 0;                           ///< 0: none
  double length_mm = 0.0;                   ///< gauge line to tip, along -Z of the machine
  double radius_mm = 0.0;                   ///< of a turning tool: of its tip
  std::optional<Edge> edge = std::nullopt;  ///< nullopt: it is round and turns
};

inline constexpr int kToolSpindle = 1;  ///< the spindle that holds and turns tools

/// A tool comes into a spindle; what was there goes.
struct ToolChange {
  Tool tool;
  int spindle = kToolSpindle;
};

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
  int spindle = kToolSpindle;       ///< or another one, of a part
};

/// An M code for the machine's own logic, which may switch something.
struct AuxiliaryCode {
  int number = 0;
};

/// A digital output of the control, which may switch something, gets a value.
struct DigitalOutput {
  int number = 0;  ///< as programs count them
  bool is_on = false;
};

/// What a program tells a machine to do that is no motion.
using MachineEvent = std::variant<ToolChange, SpindleTurn, AuxiliaryCode, DigitalOutput>;

}  // namespace g31::machine

#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "machine/units/point.h"

namespace g31::probe {

/// What the set-up sheet says about the touch probe.  Lengths in mm.
struct ProbeSetup {
  double ball_diameter_mm = 6.0;   ///< > 0
  double length_mm = 120.0;        ///< spindle gauge line to ball centre, along -Z of the machine
  std::array<double, 2> eccentricity_mm = {0.0, 0.0};  ///< ball centre off the spindle axis, X Y
  double trigger_delay_s = 0.0;    ///< >= 0
  double repeatability_mm = 0.0;   ///< standard deviation of the trigger point along the move
};

/// One `[[skip_signal]]` of the set-up sheet: the signal of one skip move, without a probe.
struct SkipSignal {
  int axis = 0;              ///< storage index: 0 X, 1 Y, 2 Z...
  std::optional<double> at;  ///< machine coordinate that raises the signal; none: no signal
};

}  // namespace g31::probe

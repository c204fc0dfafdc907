#pragma once

#include <optional>
#include <vector>

#include "interpreter/runtime/control_setup.h"
#include "machine/sim/machine_setup.h"
#include "parts/artefacts/part_setup.h"
#include "probe/sensor/probe_setup.h"

namespace g31::setup {

/// A whole set-up sheet as plain structs, one per library.
struct Job {
  runtime::ControlSetup control;
  machine::MachineSetup machine;
  std::optional<probe::ProbeSetup> probe;  ///< none: no probe in the spindle
  std::vector<parts::PartSetup> parts;
  /// Signals of the skip moves in order; given (even empty) means: instead of a probe.
  std::optional<std::vector<probe::SkipSignal>> skip_signals;
};

}  // namespace g31::setup

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/control_setup.h"
#include "machine/sim/machine_setup.h"
#include "parts/artefacts/part_setup.h"
#include "probe/sensor/displacement_sensors.h"
#include "probe/sensor/probe_setup.h"
#include "probe/tooling/tool_probe_setup.h"
#include "probe/tooling/tool_setup.h"
#include "tools/expect/expectation.h"
#include "tools/setup/setup_error.h"

namespace g31::setup {

/// A whole set-up sheet as plain structs, one per library.
struct Job {
  runtime::ControlSetup control;
  machine::MachineSetup machine;
  std::optional<probe::ProbeSetup> probe;               ///< none: no probe in the spindle
  std::optional<probe::SecondProbeSetup> second_probe;  ///< only beside a probe
  std::vector<probe::DisplacementSetup> sensors;
  std::vector<probe::ToolSetup> tools;             ///< what the magazine holds; numbers differ
  std::vector<probe::ToolProbeSetup> tool_probes;  ///< names differ
  std::vector<parts::PartSetup> parts;
  bool has_parts_on_offsets = false;  ///< places of some of them are those of work offsets
  /// Of what only the control can judge, by table and name: "variables.#500"; see RefusedSetting.
  std::map<std::string, source::ShownPlace> places;
  expect::Expectations expectations;            ///< what [expect] says
  std::vector<std::string> sheets;              ///< what it was read from, machine file included
  std::vector<source::ShownPlace> part_places;  ///< one per part: its file or shape
  /// Comments that look like variables, `#500 = 3.0`: probably meant as one.
  std::vector<source::ShownPlace> lost_variables;
  /// Signals of the skip moves in order; given (even empty) means: instead of a probe.
  std::optional<std::vector<probe::SkipSignal>> skip_signals;
};

}  // namespace g31::setup

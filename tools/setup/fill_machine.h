#pragma once

#include "machine/sim/machine_setup.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// [machine] and what is inside it, and [start]; all but the tip of its tool, which the probe says.
machine::MachineSetup machine_from(const Sheet& sheet, ErrorList& errors);

/// What the control takes the machine's kinematics for: what they are, but for [believed].
machine::AxisChainSetup believed_kinematics(const Sheet& sheet,
                                            const machine::MachineSetup& machine,
                                            ErrorList& errors);

}  // namespace g31::setup

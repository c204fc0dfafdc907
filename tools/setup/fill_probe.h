#pragma once

#include "machine/sim/machine_setup.h"
#include "probe/sensor/probe_setup.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// [probe], which is `table`, and the lists inside it.
probe::ProbeSetup probe_from(const Sheet& sheet, const SheetTable& table);

/// The digital inputs that the probe sets.
std::vector<machine::InputWire> wires_of(const SheetTable& table, int measuring_input);

}  // namespace g31::setup

#pragma once

#include <optional>

#include "machine/sim/machine_setup.h"
#include "probe/sensor/probe_setup.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// [probe], which is `table`, and the lists inside it.
probe::ProbeSetup probe_from(const Sheet& sheet, const SheetTable& table);

/// [probe.second]; nullopt: there is none, or it is wrong.
/// @param first  what [probe] says
std::optional<probe::SecondProbeSetup> second_probe_from(
    const Sheet& sheet, const std::optional<probe::ProbeSetup>& first, ErrorList& errors);

/// Height of a [[probe.body]] or [[tool.body]], mm.
double length_of_body(const SheetTable& table);

/// A round piece of a probe or tool, its edges rounded.
/// @param z_bottom    height of its lower end in the frame of ProbeSection, mm
/// @param usual_name  of one that has none
probe::ProbeSection body_from(double z_bottom, const SheetTable& table, const char* usual_name);

/// The digital inputs that the probe sets.
std::vector<machine::InputWire> wires_of(const SheetTable& table, int measuring_input);

}  // namespace g31::setup

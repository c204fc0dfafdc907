#pragma once

#include "probe/sensor/probe_setup.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// [probe], which is `table`, and the lists inside it.
probe::ProbeSetup probe_from(const Sheet& sheet, const SheetTable& table);

}  // namespace g31::setup

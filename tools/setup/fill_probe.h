#pragma once

#include <optional>

#include "probe/sensor/probe_setup.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// [probe] and what is inside it; nullopt where the sheet has none.
std::optional<probe::ProbeSetup> probe_from(const Sheet& sheet);

}  // namespace g31::setup

#pragma once

#include "tools/setup/job.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// What [[tool]] says, with its teeth and bodies.  A tool of kind probe becomes the tool of
/// [probe] where that has none.
/// @param errors  gets a number that two tools have, keys that the kind needs or does not take, and
///                sizes that do not go together
void fill_tools(Job& job, const Sheet& sheet, ErrorList& errors);

/// What [[tool_probe]] says.
/// @param errors  gets a name that two have, and sizes that the shape does not have
void fill_tool_probes(Job& job, const Sheet& sheet, ErrorList& errors);

}  // namespace g31::setup

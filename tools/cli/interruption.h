#pragma once

#include "interpreter/runtime/interruption.h"

namespace g31::cli {

/// From here on the first Ctrl-C, or a terminal that is closed, asks the command in hand to end
/// cleanly; the second ends the process at once.
const runtime::Interruption& catch_interruption();

/// The same for SIGTERM, for a command that must not leave behind what it has begun.
void catch_termination();

}  // namespace g31::cli

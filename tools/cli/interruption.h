#pragma once

#include "interpreter/runtime/interruption.h"

namespace g31::cli {

/// From here on the first Ctrl-C, a terminal that is closed or a SIGTERM asks the command in hand
/// to end cleanly; the second ends the process at once.
const runtime::Interruption& catch_interruption();

}  // namespace g31::cli

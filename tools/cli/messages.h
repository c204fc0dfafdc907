#pragma once

#include <string>

#include "interpreter/runtime/outcome.h"
#include "tools/cli/exit_code.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// The messages of a run, on standard error.
/// @param sources  of the programs that ran
void print_diagnostics(const runtime::Outcome& outcome, const source::SourceMap& sources);

/// Says why on standard error, as with_ended_wait().
ExitCode refuse(const session::Refusal& wrong);

}  // namespace g31::cli

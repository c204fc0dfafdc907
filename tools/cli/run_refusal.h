#pragma once

#include <functional>
#include <string>

#include "machine/base/result.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/run_command.h"
#include "tools/session/refusal.h"

namespace g31::cli {

using RunWork = std::function<Result<ExitCode, session::Refusal>()>;

/// Does the work of a run.  Why it cannot begin is told on standard error, and in the document of
/// --json: status `usage`, `setup`, `budget`, `interrupted`, or `defect` for a contract of ours
/// that is violated; and in the page of --report.  A document of an earlier run is gone before the
/// work begins.
ExitCode run_or_tell(const RunOptions& options, const RunWork& work);

/// The document of a command line that is refused before anything is read of it.
/// @param json  where --json wants it; "": nowhere
void tell_usage_error(const RunOptions& options, const std::string& json, const std::string& why);

}  // namespace g31::cli

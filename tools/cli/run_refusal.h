#pragma once

#include <functional>

#include "machine/base/result.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/run_command.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// Makes a run ready and does it; calls `begins` in between.
using RunWork =
    std::function<Result<ExitCode, session::Refusal>(const std::function<void()>& begins)>;

/// Does the work of a run.  Why it cannot begin is told on standard error, and in the document of
/// --json where the contract has a status for it: `setup`, `budget`, `interrupted`, or `defect` for
/// a contract of ours that is violated before the run begins.  Wrong usage leaves no document.
ExitCode run_or_tell(const RunOptions& options, const RunWork& work);

}  // namespace g31::cli

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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

/// Why something that the run writes may not be where it is wanted.
/// @param read  what the run reads, or has read, beside the files of the command line
std::optional<session::Refusal> wrong_place_of(const RunOptions& options,
                                               const std::vector<std::string>& read);

/// Writes the document of a run whose command line is refused before anything is read of it.
/// @param json  where --json wants it
void tell_usage_error(const RunOptions& options, const std::string& json, const std::string& why);

}  // namespace g31::cli

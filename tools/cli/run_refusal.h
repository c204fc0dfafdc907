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

/// How far a run is.
enum class RunStage {
  IsAsked,   ///< it is also looked whether what is written last can be written
  IsRead,    ///< its sheets are
  HasEnded,  ///< its events are under way where --jsonl wants them, and no place for others
};

/// Refuses a run that may not write something where it is wanted: on standard error, and in
/// documents whose own places are sound.  @returns nullopt: it may
/// @param read  what the run reads, or has read, beside the files of the command line
std::optional<ExitCode> refused_places(const RunOptions& options,
                                       const std::vector<std::string>& read, RunStage stage);

/// Writes the document of a run whose command line is refused before anything is read of it.
/// @param json  where --json wants it
void tell_usage_error(const RunOptions& options, const std::string& json, const std::string& why);

}  // namespace g31::cli

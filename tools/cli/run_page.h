#pragma once

#include <optional>

#include "tools/cli/run_result.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// Why --report cannot be done, whatever the run will come to; nullopt: it can, or nobody wants it.
std::optional<session::Refusal> wrong_report(const RunOptions& options);

/// Writes the report.  @returns why it could not be written
std::optional<session::Refusal> deliver_page(const OpenedRun& opened,
                                             const report::RunResult& result);

}  // namespace g31::cli

#pragma once

#include <memory>
#include <optional>

#include "interpreter/runtime/output_budget.h"
#include "machine/base/result.h"
#include "tools/cli/run_command.h"
#include "tools/report/readings_file.h"
#include "tools/report/trace_file.h"
#include "tools/session/refusal.h"
#include "tools/setup/job.h"

namespace g31::cli {

/// What is written row by row while the program runs; null where it is not asked for.
struct Tables {
  std::shared_ptr<report::TraceFile> trace;
  std::shared_ptr<report::ReadingsFile> readings;

  /// Gives the files their names.  @returns why one is not whole
  [[nodiscard]] std::optional<session::Refusal> finish() const;
};

/// The files of --trace and --readings.
Result<Tables, session::Refusal> open_tables(const RunOptions& options, const setup::Job& job,
                                             runtime::OutputBudget& budget);

}  // namespace g31::cli

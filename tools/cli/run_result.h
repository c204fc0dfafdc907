#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/time_budget.h"
#include "machine/sim/machining_centre.h"
#include "tools/cli/run_command.h"
#include "tools/report/run_document.h"
#include "tools/report/run_recorder.h"
#include "tools/session/heard.h"
#include "tools/session/prepare.h"
#include "tools/session/run.h"

namespace g31::cli {

/// A run that can begin, or that has ended, with what it writes as it goes.
struct OpenedRun {
  const RunOptions& options;
  const std::vector<std::string>& prints;  ///< names of variables
  const session::Prepared& prepared;
  session::Run& run;
  machine::MachiningCentre& machine;
  const report::RunRecorder& recorder;
  runtime::OutputBudget& output;
  const runtime::TimeBudget& time;
  const source::SourceMap& sources;
  const std::vector<source::Diagnostic>& part_findings;
};

/// What a run that has ended tells.
/// @param values  of the variables asked for
report::RunResult result_of(const OpenedRun& opened, const session::Heard& heard,
                            const runtime::NamedValues& values);

/// Sends the result where it goes: the document, or the variables asked for as lines.
/// @returns why it could not be written
std::optional<session::Refusal> deliver(const OpenedRun& opened, const report::RunResult& result);

}  // namespace g31::cli

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/time_budget.h"
#include "machine/sim/machining_centre.h"
#include "tools/cli/run_command.h"
#include "tools/cli/run_inputs.h"
#include "tools/expect/expectation.h"
#include "tools/page/other_run.h"
#include "tools/picture/way_recorder.h"
#include "tools/report/run_document.h"
#include "tools/report/run_recorder.h"
#include "tools/session/heard.h"
#include "tools/session/prepare.h"
#include "tools/session/run.h"
#include "tools/session/world.h"

namespace g31::cli {

/// A run that can begin, or that has ended, with what it writes as it goes.
struct OpenedRun {
  const RunOptions& options;
  const std::vector<std::string>& prints;  ///< names of variables
  bool prints_all = false;                 ///< and all others
  const session::Prepared& prepared;
  session::Run& run;
  machine::MachiningCentre& machine;
  const report::RunRecorder& recorder;
  report::RunChronicle* chronicle = nullptr;  ///< nullptr: nobody wants it
  const picture::WayRecorder& ways;           ///< of the ball; none unless a report is wanted
  runtime::OutputBudget& output;
  const runtime::TimeBudget& time;
  const source::SourceMap& sources;
  const session::World& world;
  const expect::Expectations& expectations;
  const page::OtherRun* other = nullptr;  ///< that the page shows beside it; nullptr: none
  RunInputs* inputs;                      ///< nullptr: nobody asks for them
  const disk::RememberingDisk& disk;
};

/// What a run that has ended tells of itself; what was made of it is still to be said.
report::RunResult result_of(const OpenedRun& opened, const session::Heard& heard);

/// The variables asked for as lines of standard output, behind all that was printed there; nothing
/// where a document goes there.
/// @returns why it could not be written
std::optional<session::Refusal> print_values(const OpenedRun& opened,
                                             const report::RunResult& result);

/// The document, where one is wanted.  @returns why it could not be written
std::optional<session::Refusal> deliver(const OpenedRun& opened, const report::RunResult& result);

}  // namespace g31::cli

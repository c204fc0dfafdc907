#include "tools/cli/run_command.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/time_budget.h"
#include "tools/cli/messages.h"
#include "tools/cli/printouts.h"
#include "tools/cli/run_expectations.h"
#include "tools/cli/run_recorder.h"
#include "tools/cli/run_refusal.h"
#include "tools/cli/run_result.h"
#include "tools/cli/run_tables.h"
#include "tools/cli/run_verdict.h"
#include "tools/disk/disk.h"
#include "tools/session/sheet_places.h"
#include "tools/session/world.h"
#include "tools/setup/duration.h"
#include "tools/setup/name_list.h"

namespace g31::cli {
namespace {

using session::Refusal;

/// What the command line alone says, checked before anything runs.
struct Checked {
  std::vector<std::string> prints;
  double trace_period_s = 0.0;
};

Result<Checked, Refusal> checked(const RunOptions& options) {
  Checked checked;
  const auto period = setup::parse_duration(options.trace_period);
  if (!period) {
    return session::bad_input(fmt::format("--trace-period: {}", period.error()));
  }
  checked.trace_period_s = period.value();
  for (const std::string& list : options.prints) {
    const auto names = setup::parse_name_list(list);
    if (!names) {
      return session::bad_input(fmt::format("--print {}: {}", list, names.error()));
    }
    checked.prints.insert(checked.prints.end(), names.value().begin(), names.value().end());
  }
  return checked;
}

/// What the run came to, with what was found before it, without what is allowed.
session::Heard carried_out(const OpenedRun& opened) {
  runtime::Budget budget = opened.options.budget;
  budget.output = &opened.output;
  budget.wall_seconds = opened.time.left_s();
  session::Heard heard =
      session::heard(session::with_findings(opened.part_findings, opened.run.session().run(budget)),
                     opened.prepared.control, opened.options.programs.front(),
                     opened.options.allowed, opened.sources);
  session::place_settings(opened.prepared.job, heard.outcome.diagnostics);
  return heard;
}

/// Saves what the run leaves behind.  What a defect left is told, not kept; a program that was
/// refused has left nothing.
std::optional<Refusal> keep_state(const OpenedRun& opened, const runtime::Outcome& outcome) {
  const bool has_run = outcome.status != runtime::Status::SyntaxError || outcome.blocks > 0;
  return has_run && outcome.status != runtime::Status::Defect ? opened.run.keep_state()
                                                              : std::nullopt;
}

/// What could not be written or kept.
std::vector<Refusal> unwritten_files(const OpenedRun& opened, const Tables& tables,
                                     Printouts& printouts, const runtime::Outcome& outcome) {
  std::vector<Refusal> problems;
  for (const auto& wrong : {tables.finish(), printouts.finish()}) {
    if (wrong) {
      problems.push_back(*wrong);
    }
  }
  if (const auto wrong = problems.empty() ? keep_state(opened, outcome) : std::nullopt) {
    problems.push_back(*wrong);
  }
  return problems;
}

ExitCode run_to_end(const OpenedRun& opened, const Tables& tables, Printouts& printouts) {
  const session::Heard heard = carried_out(opened);
  report::RunResult result = result_of(opened, heard);
  std::vector<Refusal> problems = unwritten_files(opened, tables, printouts, heard.outcome);
  session::Run::Values found = opened.run.values(opened.prints);
  result.variables = std::move(found.values);
  result.expectations = judged(opened.expectations, opened, heard.outcome);
  const ExitCode code =
      exit_code_of(heard.outcome, {opened.options.fail_on, opened.expectations, result.expectations,
                                   found.wrong.has_value(), !problems.empty()});
  if (found.wrong) {
    problems.push_back(session::bad_input(fmt::format("--print: {}", *found.wrong)));
  }
  std::vector<source::Diagnostic>& messages = result.outcome.diagnostics;
  std::ranges::move(failures_of(result.expectations), std::back_inserter(messages));
  print_diagnostics(result.outcome, opened.sources);
  for (const Refusal& problem : problems) {
    refuse(problem);
    messages.push_back(message_of(problem));
  }
  result.exit_code = static_cast<int>(code);
  const auto undelivered = deliver(opened, result);
  return undelivered ? refuse(*undelivered) : code;
}

void connect(const Printouts& printouts, session::Run& run) {
  if (runtime::PrinterPort* const printer = printouts.printer()) {
    run.session().connect(*printer);
  }
}

/// What names ask for and the control has not.
std::optional<Refusal> unusable(const Checked& line, const expect::Expectations& expectations,
                                session::Run& run) {
  if (const auto wrong = run.wrong_name(line.prints)) {
    return session::bad_input(fmt::format("--print: {}", *wrong));
  }
  return wrong_expectation(expectations, run);
}

/// What a run is given, as it is before the run; nothing where no document tells it.
RunInputs inputs_before(const RunOptions& options, const setup::Job& job) {
  RunInputs inputs;
  if (!options.json.empty()) {
    inputs.add(options);
    inputs.add(job);
  }
  return inputs;
}

/// Makes a run ready and does it.
Result<ExitCode, Refusal> do_run(const RunOptions& options) {
  disk::Disk disk;
  RememberingDisk remembering(disk);
  const auto prepared = session::prepare(options, remembering, session::VariablesFile::IsSaved);
  if (!prepared) {
    return prepared.error();
  }
  if (const std::string& note = prepared.value().note; !note.empty()) {
    fmt::print(stderr, "g31: note: {}\n", note);
  }
  const auto line = checked(options);
  if (!line) {
    return line.error();
  }
  const setup::Job& job = prepared.value().job;
  const auto expectations = expectations_of(job, options.expects);
  if (!expectations) {
    return expectations.error();
  }
  RunInputs inputs = inputs_before(options, job);
  const session::Control& control = prepared.value().control;
  runtime::OutputBudget output(options.max_output);
  const auto tables = open_tables(options, job, output);
  if (!tables) {
    return tables.error();
  }
  runtime::TimeBudget time(options.budget.wall_seconds, options.budget.interruption);
  const auto world = session::build_world(job, options.seed, &time);
  if (!world) {
    return world.error();
  }
  const auto printouts = Printouts::open(options);
  if (!printouts) {
    return printouts.error();
  }
  machine::MachiningCentre& machine = *world.value().machine;
  EchoingRecorder recorder(options, *printouts.value(), machine, tables.value(), output);
  if (expectations.value().need_output()) {
    recorder.keep_output();
  }
  if (tables.value().trace != nullptr) {
    machine.trace(line.value().trace_period_s, *tables.value().trace);
  }
  const auto programs = session::open_programs(control, options, remembering, job.control);
  if (!programs) {
    return programs.error();
  }
  const auto opened = session::Run::open(job, *programs.value(), machine, recorder);
  if (!opened) {
    return opened.error();
  }
  connect(*printouts.value(), *opened.value());
  if (const auto wrong = unusable(line.value(), expectations.value(), *opened.value())) {
    return *wrong;
  }
  return run_to_end({options, line.value().prints, prepared.value(), *opened.value(), machine,
                     recorder, output, time, programs.value()->sources(), world.value().findings,
                     expectations.value(), inputs, remembering},
                    tables.value(), *printouts.value());
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  return run_or_tell(options, [&] { return do_run(options); });
}

}  // namespace g31::cli

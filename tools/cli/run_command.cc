#include "tools/cli/run_command.h"

#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/time_budget.h"
#include "tools/cli/messages.h"
#include "tools/cli/printouts.h"
#include "tools/cli/run_recorder.h"
#include "tools/cli/run_refusal.h"
#include "tools/cli/run_result.h"
#include "tools/cli/run_tables.h"
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

ExitCode run_to_end(const OpenedRun& opened, const Tables& tables, Printouts& printouts) {
  const session::Heard heard = carried_out(opened);
  for (const auto& wrong : {tables.finish(), printouts.finish()}) {
    if (wrong) {
      return refuse(*wrong);
    }
  }
  print_diagnostics(heard.outcome, opened.sources);
  const session::Run::Values found = opened.run.values(opened.prints);
  for (const auto& wrong : {deliver(opened, result_of(opened, heard, found.values)),
                            keep_state(opened, heard.outcome)}) {
    if (wrong) {
      return refuse(*wrong);
    }
  }
  const ExitCode code = exit_code_of(session::ending_of(heard.outcome, opened.options.fail_on));
  if (!found.wrong) {
    return code;
  }
  const ExitCode unread = refuse(session::bad_input(fmt::format("--print: {}", *found.wrong)));
  const bool has_completed = heard.outcome.status == runtime::Status::Completed;
  return has_completed ? unread : code;
}

/// Makes a run ready and does it.
Result<ExitCode, Refusal> begin_run(const RunOptions& options,
                                    const std::function<void()>& begins) {
  disk::Disk disk;
  const auto prepared = session::prepare(options, disk, session::VariablesFile::IsSaved);
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
  if (tables.value().trace != nullptr) {
    machine.trace(line.value().trace_period_s, *tables.value().trace);
  }
  const auto programs = session::open_programs(control, options, disk, job.control);
  if (!programs) {
    return programs.error();
  }
  const auto opened = session::Run::open(job, *programs.value(), machine, recorder);
  if (!opened) {
    return opened.error();
  }
  if (runtime::PrinterPort* const printer = printouts.value()->printer()) {
    opened.value()->session().connect(*printer);
  }
  if (const auto wrong = opened.value()->wrong_name(line.value().prints)) {
    return session::bad_input(fmt::format("--print: {}", *wrong));
  }
  begins();
  return run_to_end({options, line.value().prints, prepared.value(), *opened.value(), machine,
                     recorder, output, time, programs.value()->sources(), world.value().findings},
                    tables.value(), *printouts.value());
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  return run_or_tell(
      options, [&](const std::function<void()>& begins) { return begin_run(options, begins); });
}

}  // namespace g31::cli

#include "tools/cli/run_command.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/runtime/time_budget.h"
#include "tools/cli/desk.h"
#include "tools/cli/ended_wait.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/printouts.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_expectations.h"
#include "tools/cli/run_page.h"
#include "tools/cli/run_recorder.h"
#include "tools/cli/run_refusal.h"
#include "tools/cli/run_result.h"
#include "tools/cli/run_state.h"
#include "tools/cli/run_tables.h"
#include "tools/cli/run_verdict.h"
#include "tools/disk/disk.h"
#include "tools/report/event_log.h"
#include "tools/session/expected_names.h"
#include "tools/session/sheet_places.h"
#include "tools/session/world.h"
#include "tools/setup/duration.h"
#include "tools/setup/job_files.h"
#include "tools/setup/name_list.h"

namespace g31::cli {
namespace {

using session::Refusal;

/// What the command line and the sheets say beside the job, checked before anything runs.
struct Checked {
  std::vector<std::string> prints;
  bool prints_all = false;
  double trace_period_s = 0.0;
  expect::Expectations expectations;
  std::optional<page::OtherRun> other;  ///< of --compare
};

/// Among the names of --print: every variable that has a value.
constexpr std::string_view kAllValues = "all";

Result<Checked, Refusal> checked(const RunOptions& options, const setup::Job& job) {
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
  checked.prints_all = std::erase(checked.prints, kAllValues) > 0;
  const auto expectations = expectations_of(job, options.expects);
  if (!expectations) {
    return expectations.error();
  }
  checked.expectations = expectations.value();
  if (const auto wrong =
          options.watch != nullptr ? why_no_page("g31 view") : wrong_report(options.report)) {
    return *wrong;
  }
  if (!options.compare.empty()) {
    auto other = compared_run(options.compare, job);
    if (!other) {
      return other.error();
    }
    checked.other = other.value();
  }
  return checked;
}

/// What the run came to, with what was found before it, without what is allowed.
/// @param watch  hears the run, if need be
session::Heard carried_out(const OpenedRun& opened, Desk& desk, ResultWatch& watch) {
  runtime::Budget budget = opened.options.budget;
  budget.output = &opened.output;
  budget.wall_seconds = opened.time.left_s();
  const std::function<void(std::uint64_t)> progress = [&](std::uint64_t blocks) {
    desk.progress(blocks, opened.machine.time_s());
  };
  budget.progress = &progress;
  runtime::BlockListener* const listener =
      watch.is_needed() ? &watch : static_cast<runtime::BlockListener*>(opened.chronicle);
  session::ProgramComments comments(opened.sources.files(), opened.prepared.control);
  session::Heard heard = session::heard(
      session::with_findings(opened.world.findings, opened.run.session().run(budget, listener)),
      comments, opened.options.programs.front(), opened.options.allowed, opened.sources);
  opened.machine.end_trace();
  desk.give_way();
  if (opened.chronicle != nullptr) {
    opened.chronicle->finish();
  }
  session::place_settings(opened.prepared.job, heard.outcome.diagnostics);
  opened.recorder.missed_skips().tell_nearest(opened.prepared.job, opened.world.parts,
                                              heard.outcome.diagnostics);
  return heard;
}

/// Saves what the run leaves behind.  What a defect left is told, not kept; a program that was
/// refused has left nothing.  Programs of the command line and what sheets name stay as they were;
/// a subprogram may be made anew by each run that calls it.
std::optional<Refusal> keep_state(const OpenedRun& opened, const runtime::Outcome& outcome) {
  const bool has_run = outcome.status != runtime::Status::SyntaxError || outcome.blocks > 0;
  const bool leaves_nothing = opened.options.watch != nullptr;
  if (!has_run || leaves_nothing || outcome.status == runtime::Status::Defect) {
    return std::nullopt;
  }
  const InputLists inputs = {opened.options.programs, setup::files_of(opened.prepared.job)};
  for (const std::string& file : opened.run.kept_files()) {
    if (wrong_place({{"WRITE", file}}, inputs)) {
      return session::bad_input(fmt::format(
          "WRITE or DELETE of {}, of which the run is made: none of its files is kept", file));
    }
  }
  return opened.run.keep_state();
}

/// Where a run writes while it goes, and behind it.
struct Outputs {
  const Tables& tables;
  Printouts& printouts;
  Desk& desk;
  report::EventLog* events;  ///< nullptr: nobody wants them
};

/// What could not be written or kept.  Tables of a run that was broken off are half of what was
/// asked for: they are not left.
std::vector<Refusal> unwritten_files(const OpenedRun& opened, const Outputs& outputs,
                                     const runtime::Outcome& outcome) {
  std::vector<Refusal> problems;
  const bool is_broken_off = outcome.status == runtime::Status::Interrupted;
  for (const auto& wrong :
       {is_broken_off ? std::nullopt : outputs.tables.finish(), outputs.printouts.finish()}) {
    if (wrong) {
      problems.push_back(*wrong);
    }
  }
  if (const auto wrong = problems.empty() ? keep_state(opened, outcome) : std::nullopt) {
    problems.push_back(*wrong);
  }
  return problems;
}

/// Fills in the values that the run has left.  @returns why one of --print cannot be read
std::optional<Refusal> add_values(const OpenedRun& opened, const RunState& before,
                                  report::RunResult& result) {
  session::Run::Values found = opened.run.values(opened.prints);
  result.variables = std::move(found.values);
  session::Session& session = opened.run.session();
  if (opened.prints_all) {
    std::ranges::move(all_values(session), std::back_inserter(result.variables));
  }
  if (result.outcome.alarm) {
    result.locals = locals_of(session, *result.outcome.alarm);
  }
  if (opened.options.changes) {
    result.changes = changes_since(before, session);
  }
  return found.wrong ? std::optional(session::bad_input(fmt::format("--print: {}", *found.wrong)))
                     : std::nullopt;
}

/// Sends everything where it goes; the document and the page say what of it nobody could read on
/// standard output or in the log of --jsonl, which come before them.
/// @returns why it could not be
std::vector<Refusal> deliver_all(const OpenedRun& opened, const Outputs& outputs,
                                 report::RunResult& result) {
  std::vector<Refusal> problems;
  const auto keep = [&](const std::optional<Refusal>& wrong) {
    if (wrong) {
      problems.push_back(*wrong);
      result.outcome.diagnostics.push_back(message_of(*wrong));
      result.exit_code = static_cast<int>(exit_code_of(with_ended_wait(*wrong).ending));
    }
  };
  keep(print_values(opened, result));
  if (outputs.events != nullptr) {
    const auto wrong = outputs.events->finish(result, opened.recorder.touch_count());
    keep(wrong ? std::optional(session::bad_input(*wrong)) : std::nullopt);
  }
  if (const auto wrong = deliver(opened, result)) {
    problems.push_back(*wrong);
  }
  if (wants_page(opened.options)) {
    if (const auto wrong = deliver_page(opened, result)) {
      problems.push_back(*wrong);
    }
  }
  return problems;
}

ExitCode run_to_end(const OpenedRun& opened, const Outputs& outputs) {
  const RunState before = opened.options.changes ? state_of(opened.run.session()) : RunState();
  ResultWatch watch(
      opened.expectations, [&](const std::string& name) { return value_of(opened, name); },
      opened.chronicle);
  const session::Heard heard = carried_out(opened, outputs.desk, watch);
  // Which programs are called and which files are written shows while it runs.
  std::vector<std::string> used = opened.disk.paths();
  std::ranges::move(opened.run.kept_files(), std::back_inserter(used));
  if (const auto refused = refused_places(opened.options, used, RunStage::HasEnded)) {
    return *refused;
  }
  report::RunResult result = result_of(opened, heard);
  std::vector<Refusal> problems = unwritten_files(opened, outputs, heard.outcome);
  std::optional<ExitCode> unwritten;
  if (!problems.empty()) {
    unwritten = exit_code_of(with_ended_wait(problems.front()).ending);
  }
  const auto unread = add_values(opened, before, result);
  const expect::Actual actual = actual_of(opened, heard.outcome, watch);
  result.expectations = expect::judge(opened.expectations, actual);
  result.characteristics = expect::measured(opened.expectations, actual);
  ExitCode code = exit_code_of(heard.outcome, {opened.options.fail_on, opened.expectations,
                                               result.expectations, unread.has_value(), unwritten});
  if (unread) {
    problems.push_back(*unread);
  }
  std::vector<source::Diagnostic>& messages = result.outcome.diagnostics;
  std::ranges::move(failures_of(result.expectations), std::back_inserter(messages));
  outputs.desk.tell(result, opened.recorder);
  for (const Refusal& problem : problems) {
    refuse(problem);
    messages.push_back(message_of(problem));
  }
  result.exit_code = static_cast<int>(code);
  for (const Refusal& problem : deliver_all(opened, outputs, result)) {
    code = refuse(problem);
  }
  if (!unwritten) {
    outputs.desk.end(result, opened.recorder);
  }
  return code;
}

/// Connects the printer.  @returns what names ask for and the control has not
std::optional<Refusal> unusable(const Checked& line, session::Run& run,
                                const Printouts& printouts) {
  if (runtime::PrinterPort* const printer = printouts.printer()) {
    run.session().connect(*printer);
  }
  if (const auto wrong = run.wrong_name(line.prints)) {
    return session::bad_input(fmt::format("--print: {}", *wrong));
  }
  return session::wrong_expectation(line.expectations, run);
}

/// The log of --jsonl with its first line; null where nobody wants it.
Result<std::shared_ptr<report::EventLog>, Refusal> open_events(const RunOptions& options,
                                                               const session::Control& control,
                                                               const source::SourceMap& sources,
                                                               runtime::OutputBudget& budget) {
  if (options.jsonl.empty()) {
    return std::shared_ptr<report::EventLog>();
  }
  const auto events = report::EventLog::create(options.jsonl, sources, budget);
  if (!events) {
    return session::bad_input(events.error());
  }
  report::RunResult start;
  start.version = options.version;
  start.program = options.programs.front();
  start.control = session::name_of(control);
  start.seed = options.seed;
  start.optional_stop = options.optional_stop;
  events.value()->start(start);
  return events.value();
}

/// What recorder and machine are to keep from the start.
void begin_records(const Checked& line, const Tables& tables, EchoingRecorder& recorder,
                   machine::MachiningCentre& machine) {
  if (line.expectations.need_output()) {
    recorder.keep_output();
  }
  if (tables.trace != nullptr) {
    machine.trace(line.trace_period_s, *tables.trace);
  }
}

/// What the program drives: a page has its ways.
machine::MachinePort& port_of(const RunOptions& options, machine::MachiningCentre& machine,
                              picture::WayRecorder& ways) {
  if (!wants_page(options)) {
    return machine;
  }
  machine.tell_motions_to(ways);
  return ways;
}

/// What calls name the main program by.
std::string main_name(const RunOptions& options) {
  return std::filesystem::path(options.programs.front()).stem().string();
}

/// Opens what the run writes and does it.
/// @param disk  that has been read from so far
Result<ExitCode, Refusal> open_and_run(const RunOptions& options, const session::Prepared& prepared,
                                       const Checked& line, disk::RememberingDisk& disk) {
  const setup::Job& job = prepared.job;
  std::optional<RunInputs> inputs;
  if (!options.json.empty() || wants_page(options)) {
    inputs.emplace();
    inputs->add(options);
    inputs->add(job);
  }
  runtime::OutputBudget output(options.max_output);
  const auto tables = open_tables(options, job, output);
  if (!tables) {
    return tables.error();
  }
  runtime::TimeBudget time(options.budget.wall_seconds, options.budget.interruption);
  const auto world = session::build_world(job, options.seed, &time, options.parts);
  if (!world) {
    return world.error();
  }
  const auto printouts = Printouts::open(options);
  if (!printouts) {
    return printouts.error();
  }
  const auto programs = session::open_programs(prepared.control, options, disk, job.control);
  if (!programs) {
    return programs.error();
  }
  const source::SourceMap& sources = programs.value()->sources();
  machine::MachiningCentre& machine = *world.value().machine;
  Desk desk(options, sources);
  EchoingRecorder recorder(options, *printouts.value(), machine, tables.value(), output);
  recorder.tell(desk, nullptr);
  std::optional<report::RunChronicle> chronicle;
  if (options.blocks || wants_page(options)) {
    chronicle.emplace(main_name(options), machine, output);
  }
  begin_records(line, tables.value(), recorder, machine);
  picture::WayRecorder ways(machine, job, output);
  machine::MachinePort& port = port_of(options, machine, ways);
  const auto run = session::Run::open(job, *programs.value(), port, recorder);
  if (!run) {
    return run.error();
  }
  if (const auto wrong = unusable(line, *run.value(), *printouts.value())) {
    return *wrong;
  }
  // Behind all that may refuse the run: standard output has one beginning.
  const auto events = open_events(options, prepared.control, sources, output);
  if (!events) {
    return events.error();
  }
  recorder.tell(desk, events.value().get());
  return run_to_end(
      {options, line.prints, line.prints_all, prepared, *run.value(), machine, recorder,
       chronicle ? &*chronicle : nullptr, ways, output, time, sources, world.value(),
       line.expectations, line.other ? &*line.other : nullptr, inputs ? &*inputs : nullptr, disk},
      {tables.value(), *printouts.value(), desk, events.value().get()});
}

/// Tells of the files that are read without the disk of the run.
void look_at(const setup::Job& job, const Watch& watch) {
  for (const std::string& sheet : job.sheets) {
    watch.looked(sheet);
  }
  for (const parts::PartSetup& part : job.parts) {
    watch.looked(part.file);
  }
}

void tell_note(const std::string& note) {
  std::fputs(fmt::format("g31: note: {}\n", note).c_str(), stderr);
}

/// Makes a run ready and does it.
Result<ExitCode, Refusal> do_run(const RunOptions& options) {
  disk::Disk disk;
  disk::RememberingDisk remembering(disk);
  if (options.watch != nullptr) {
    remembering.tell(options.watch->looked);
  }
  const auto read = session::prepare(
      options, remembering,
      options.watch == nullptr ? session::VariablesFile::IsSaved : session::VariablesFile::IsRead);
  if (!read) {
    return read.error();
  }
  session::Prepared prepared = read.value();
  prepared.job.control.block_skip.insert(options.block_skip.begin(), options.block_skip.end());
  if (!prepared.note.empty()) {
    tell_note(prepared.note);
  }
  if (options.watch != nullptr) {
    look_at(prepared.job, *options.watch);
  }
  if (const auto refused =
          refused_places(options, setup::files_of(prepared.job), RunStage::IsRead)) {
    return *refused;
  }
  const auto line = checked(options, prepared.job);
  if (line && line.value().other && !line.value().other->has_times) {
    tell_note(
        fmt::format("--compare {} tells no times of its moves: the time line shows its "
                    "touches alone; write it with --blocks, too",
                    options.compare));
  }
  return line ? open_and_run(options, prepared, line.value(), remembering)
              : Result<ExitCode, Refusal>(line.error());
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  return run_or_tell(options, [&] { return do_run(options); });
}

}  // namespace g31::cli

#include "tools/cli/run_command.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/runtime/time_budget.h"
#include "interpreter/source/latin_1.h"
#include "tools/cli/messages.h"
#include "tools/cli/printouts.h"
#include "tools/cli/run_refusal.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/report/readings_file.h"
#include "tools/report/run_document.h"
#include "tools/report/run_recorder.h"
#include "tools/report/trace_file.h"
#include "tools/session/run.h"
#include "tools/session/sheet_places.h"
#include "tools/session/world.h"
#include "tools/setup/duration.h"
#include "tools/setup/name_list.h"

namespace g31::cli {
namespace {

using session::Refusal;

/// What is written row by row while the program runs; null where it is not asked for.
struct Tables {
  std::shared_ptr<report::TraceFile> trace;
  std::shared_ptr<report::ReadingsFile> readings;
};

/// The files of --trace and --readings.
Result<Tables, Refusal> open_tables(const RunOptions& options, const setup::Job& job,
                                    runtime::OutputBudget& budget) {
  std::array<bool, kAxisCount> axes{};
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    axes.at(i) = job.machine.axes[i].present;
  }
  Tables tables;
  if (!options.trace.empty()) {
    const auto trace = report::TraceFile::create(options.trace, axes, budget);
    if (!trace) {
      return session::bad_input(trace.error());
    }
    tables.trace = trace.value();
  }
  if (!options.readings.empty()) {
    std::vector<report::ReadingsFile::Column> sensors;
    for (const probe::DisplacementSetup& sensor : job.sensors) {
      sensors.push_back({sensor.name, sensor.input});
    }
    const auto readings = report::ReadingsFile::create(options.readings, axes, sensors, budget);
    if (!readings) {
      return session::bad_input(readings.error());
    }
    tables.readings = readings.value();
  }
  return tables;
}

/// Closes what was written while the program ran.
std::optional<Refusal> finish_files(const Tables& tables, Printouts& printouts) {
  for (const auto& problem :
       {tables.trace != nullptr ? tables.trace->finish() : std::nullopt,
        tables.readings != nullptr ? tables.readings->finish() : std::nullopt}) {
    if (problem) {
      return session::bad_input(*problem);
    }
  }
  return printouts.finish();
}

/// Prints while the program runs.  Without a document nothing is kept: an endless loop may print
/// and stop for hours.
class EchoingRecorder final : public report::RunRecorder {
 public:
  /// @param tables  readings get a row at every stop
  EchoingRecorder(const RunOptions& options, Printouts& printouts,
                  const machine::MachinePort& machine, const Tables& tables,
                  runtime::OutputBudget& budget)
      : RunRecorder({options.moves ? Keep::Yes : Keep::No, options.touches ? Keep::Yes : Keep::No},
                    budget),
        printouts_(printouts),
        keeps_(!options.json.empty()),
        machine_(machine),
        readings_(tables.readings.get()) {}
  void on_move(const runtime::MoveEvent& event) override {
    constexpr int kDwell = 4;
    RunRecorder::on_move(event);
    if (event.g == kDwell) {
      read_sensors();
    }
  }
  void on_standstill(source::Location /*where*/) override { read_sensors(); }
  void on_output(const runtime::OutputEvent& event) override {
    print(event, [](std::string_view text) { return text; });
  }
  void on_message(const runtime::OutputEvent& event) override {
    print(event, [](std::string_view text) { return source::as_utf8(text); });
  }
  void on_stop(const runtime::StopEvent& event) override {
    if (keeps_) {
      RunRecorder::on_stop(event);
    }
    read_sensors();
  }

 private:
  using Keep = report::RecordWhat::Keep;

  /// What is kept is charged as it will be in the document, else as it is printed.
  template <typename Form>
  void print(const runtime::OutputEvent& event, const Form& form) {
    if (keeps_) {
      RunRecorder::on_output(event);
    } else {
      budget().charge(runtime::Output::Printouts, event.text.size());
    }
    if (!budget().is_spent()) {
      printouts_.write(form(event.text));
    }
  }

  void read_sensors() {
    if (readings_ != nullptr) {
      readings_->add_row(machine_);
    }
  }

  Printouts& printouts_;
  bool keeps_;
  const machine::MachinePort& machine_;
  report::ReadingsFile* readings_;
};

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

/// What is the matter with the probe; "" for nothing.
std::string probe_state_of(const setup::Job& job) {
  for (const auto& [state, name] : probe::kProbeStateNames) {
    if (job.probe && job.probe->state == state && state != probe::ProbeState::Ready) {
      return std::string(name);
    }
  }
  return {};
}

std::string shown(const runtime::ShownValue& value) {
  return std::visit(runtime::Overloaded{
                        [](runtime::Cell cell) {
                          return cell.is_vacant() ? "null" : fmt::format("{}", cell.raw());
                        },
                        [](const std::string& text) { return source::as_utf8(text); },
                    },
                    value);
}

/// A run that can begin, with what it writes as it goes.
struct Opened {
  const RunOptions& options;
  const Checked& line;
  const session::Prepared& prepared;
  session::Run& run;
  machine::MachiningCentre& machine;
  const report::RunRecorder& recorder;
  runtime::OutputBudget& output;
  const runtime::TimeBudget& time;
  const source::SourceMap& sources;
  const std::vector<source::Diagnostic>& part_findings;
};

/// The document has as much time as the run, but a minute at least: a run that has spent its own is
/// told, too.
std::optional<Refusal> write_document(const Opened& opened, const report::RunResult& result) {
  constexpr double kLeastSeconds = 60.0;
  runtime::TimeBudget time(std::max(kLeastSeconds, opened.options.budget.wall_seconds));
  const auto write = [&](disk::PartFile& file) {
    report::write_run_document(result, opened.recorder, opened.sources,
                               [&](std::string_view piece) {
                                 file.write(piece);
                                 time.look();
                               });
  };
  try {
    return write_out(opened.options.json, write);
  } catch (const runtime::BudgetSpent&) {
    return Refusal{session::Ending::Budget,
                   fmt::format("{}: the limit of computing time is reached with the writing of the "
                               "document: --max-time raises it",
                               opened.options.json)};
  }
}

/// Where the result goes: the document, or the variables asked for as lines.
std::optional<Refusal> deliver(const Opened& opened, const report::RunResult& result) {
  const RunOptions& options = opened.options;
  if (options.json != "-") {
    std::string text;
    for (const auto& [name, value] : result.variables) {
      text += fmt::format("{} = {}\n", name, shown(value));
    }
    if (auto wrong = write_out("-", text); wrong || options.json.empty()) {
      return wrong;
    }
  }
  return write_document(opened, result);
}

/// What the document of a run tells, behind its end.
report::RunResult result_of(const Opened& opened, const runtime::Outcome& outcome,
                            const runtime::NamedValues& values) {
  report::RunResult result;
  result.program = opened.options.programs.front();
  result.control = session::name_of(opened.prepared.control);
  result.seed = opened.options.seed;
  result.outcome = outcome;
  result.variables = values;
  result.files = opened.run.changed_files();
  result.machine_time_s = opened.machine.time_s();
  result.probe_state = probe_state_of(opened.prepared.job);
  return result;
}

/// Leaves out what --allow names; errors stay.
runtime::Outcome without_allowed(runtime::Outcome outcome,
                                 const std::vector<std::string>& allowed) {
  std::erase_if(outcome.diagnostics, [&](const source::Diagnostic& diagnostic) {
    return diagnostic.severity != source::Severity::Error &&
           std::ranges::find(allowed, diagnostic.code) != allowed.end();
  });
  return outcome;
}

ExitCode run_to_end(const Opened& opened, const Tables& tables, Printouts& printouts) {
  runtime::Budget budget = opened.options.budget;
  budget.output = &opened.output;
  budget.wall_seconds = opened.time.left_s();
  runtime::Outcome outcome = without_allowed(
      session::with_findings(opened.part_findings, opened.run.session().run(budget)),
      opened.options.allowed);
  session::place_settings(opened.prepared.job, outcome.diagnostics);
  if (const auto wrong = finish_files(tables, printouts)) {
    return refuse(*wrong);
  }
  print_diagnostics(outcome, opened.sources);
  if (outcome.status == runtime::Status::SyntaxError && !outcome.alarm) {
    return ExitCode::BadUsage;
  }
  const auto values = opened.run.values(opened.line.prints);
  if (!values) {
    return refuse(session::bad_input(fmt::format("--print: {}", values.error())));
  }
  const auto result = result_of(opened, outcome, values.value());
  if (const auto wrong = deliver(opened, result)) {
    return refuse(*wrong);
  }
  // What a defect left is told, not kept.
  const bool is_sound = outcome.status != runtime::Status::Defect;
  if (const auto wrong = is_sound ? opened.run.keep_state() : std::nullopt) {
    return refuse(*wrong);
  }
  return exit_code_of(session::ending_of(outcome));
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
  begins();
  return run_to_end({options, line.value(), prepared.value(), *opened.value(), machine, recorder,
                     output, time, programs.value()->sources(), world.value().findings},
                    tables.value(), *printouts.value());
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  return run_or_tell(
      options, [&](const std::function<void()>& begins) { return begin_run(options, begins); });
}

}  // namespace g31::cli

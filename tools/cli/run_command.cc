#include "tools/cli/run_command.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/latin_1.h"
#include "tools/cli/control_session.h"
#include "tools/cli/printouts.h"
#include "tools/cli/program_files.h"
#include "tools/cli/run_preparation.h"
#include "tools/cli/scene.h"
#include "tools/cli/variables_file.h"
#include "tools/disk/disk.h"
#include "tools/report/run_document.h"
#include "tools/report/run_recorder.h"
#include "tools/report/trace_file.h"

namespace g31::cli {
namespace {

/// Prints while the program runs.  Without a document nothing is kept: an endless loop may print
/// and stop for hours.
class EchoingRecorder final : public report::RunRecorder {
 public:
  EchoingRecorder(const RunOptions& options, Printouts& printouts)
      : RunRecorder({options.moves ? Keep::Yes : Keep::No, options.touches ? Keep::Yes : Keep::No}),
        printouts_(printouts),
        keeps_(!options.json.empty()) {}
  void on_output(std::string_view text) override {
    if (keeps_) {
      RunRecorder::on_output(text);
    }
    printouts_.write(text);
  }
  void on_message(std::string_view text) override {
    if (keeps_) {
      RunRecorder::on_output(text);
    }
    printouts_.write(source::as_utf8(text));
  }
  void on_stop(const runtime::StopEvent& event) override {
    if (keeps_) {
      RunRecorder::on_stop(event);
    }
  }

 private:
  using Keep = report::RecordWhat::Keep;
  Printouts& printouts_;
  bool keeps_;
};

/// Variables asked for by --print, with a refusal for names the control does not have.
Result<std::vector<std::pair<std::string, runtime::ShownValue>>, Refusal> read_prints(
    ControlSession& session, const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, runtime::ShownValue>> values;
  for (const std::string& name : names) {
    const auto value = session.variable(name);
    if (!value) {
      return refusal(ExitCode::BadUsage, fmt::format("--print: {}", value.error()));
    }
    values.emplace_back(name, value.value());
  }
  return values;
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

/// Where the result goes: the document, or the variables asked for as lines.
std::optional<Refusal> deliver(const RunOptions& options, const report::RunResult& result,
                               const report::RunRecorder& recorder) {
  std::string text;
  if (options.json == "-") {
    text = run_document(result, recorder);
  } else {
    for (const auto& [name, value] : result.variables) {
      text += fmt::format("{} = {}\n", name, shown(value));
    }
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return refusal(ExitCode::BadUsage,
                   fmt::format("cannot write standard output: {}", std::strerror(errno)));
  }
  if (options.json.empty() || options.json == "-") {
    return std::nullopt;
  }
  const auto problem = disk::write_whole_file(options.json, run_document(result, recorder));
  return problem ? std::optional(refusal(ExitCode::BadUsage, *problem)) : std::nullopt;
}

/// Saves the program's files, and the permanent variables for the next run, if a file for them is
/// named.
std::optional<Refusal> keep_state(const std::string& path, const ProgramFiles& files,
                                  const ControlSession& session) {
  auto problem = files.save(session.files());
  if (!problem && !path.empty()) {
    problem = disk::write_whole_file(path, variables_text(session.permanent_variables()));
  }
  return problem ? std::optional(refusal(ExitCode::BadUsage, *problem)) : std::nullopt;
}

using Trace = std::shared_ptr<report::TraceFile>;

/// The file of --trace; null when none is asked for.
Result<Trace, Refusal> open_trace(const std::string& path, const machine::MachineSetup& machine) {
  if (path.empty()) {
    return Trace();
  }
  report::TraceFile::AxesPresent axes;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    axes[i] = machine.axes[i].present;
  }
  const auto trace = report::TraceFile::create(path, axes);
  return trace ? Result<Trace, Refusal>(trace.value()) : refusal(ExitCode::BadUsage, trace.error());
}

/// Closes what was written while the program ran.
std::optional<Refusal> finish_files(const Trace& trace, Printouts& printouts) {
  if (const auto problem = trace != nullptr ? trace->finish() : std::nullopt) {
    return refusal(ExitCode::BadUsage, *problem);
  }
  return printouts.finish();
}

/// Sets a control up for the job.
/// What the control is to know before it starts.  @returns the files of the program
Result<ProgramFiles, Refusal> set_up(ControlSession& session, const setup::Job& job,
                                     const Printouts& printouts) {
  if (printouts.printer() != nullptr) {
    session.connect(*printouts.printer());
  }
  const auto refused = session.configure(job.control);
  if (!refused.empty()) {
    return refusal(ExitCode::Setup, fmt::format("{}", fmt::join(refused, "; ")));
  }
  auto files = ProgramFiles::open(job.control.files_folder);
  if (!files) {
    return refusal(ExitCode::BadUsage, files.error());
  }
  session.give_files(files.value().at_start());
  return files.value();
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  auto prepared = prepare(options);
  if (!prepared) {
    return refuse(prepared.error());
  }
  const setup::Job& job = prepared.value().job;
  const auto trace = open_trace(options.trace, job.machine);
  if (!trace) {
    return refuse(trace.error());
  }
  const auto scene = build_scene(job, options.seed);
  if (!scene) {
    return refuse({ExitCode::Setup, setup::render(scene.error())});
  }
  const auto printouts = Printouts::open(options);
  if (!printouts) {
    return refuse(printouts.error());
  }
  EchoingRecorder recorder(options, *printouts.value());
  machine::MachiningCentre& machine = *scene.value().machine;
  if (trace.value() != nullptr) {
    machine.trace(prepared.value().trace_period_s, *trace.value());
  }
  const auto opened = open_session(prepared.value().control, options, machine, recorder);
  if (!opened) {
    return refuse(opened.error());
  }
  ControlSession& session = *opened.value();
  const auto files = set_up(session, job, *printouts.value());
  if (!files) {
    return refuse(files.error());
  }
  report::RunResult result;
  result.outcome = session.run(options.budget);
  if (const auto wrong = finish_files(trace.value(), *printouts.value())) {
    return refuse(*wrong);
  }
  print_diagnostics(result.outcome);
  if (result.outcome.status == runtime::Status::SyntaxError && !result.outcome.alarm) {
    return ExitCode::BadUsage;
  }
  const auto values = read_prints(session, prepared.value().prints);
  if (!values) {
    return refuse(values.error());
  }
  result.program = options.programs.front();
  result.control = prepared.value().control.name;
  result.seed = options.seed;
  result.variables = values.value();
  result.files = files.value().changed(session.files());
  result.machine_time_s = machine.time_s();
  result.probe_state = probe_state_of(job);
  if (const auto wrong = deliver(options, result, recorder)) {
    return refuse(*wrong);
  }
  if (const auto wrong = keep_state(job.control.variables_file, files.value(), session)) {
    return refuse(*wrong);
  }
  return exit_code_of(result.outcome);
}

}  // namespace g31::cli

#include "tools/cli/run_command.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/session.h"
#include "interpreter/source/diagnostic.h"
#include "tools/cli/disk.h"
#include "tools/cli/run_preparation.h"
#include "tools/cli/scene.h"
#include "tools/cli/variables_file.h"
#include "tools/report/run_document.h"
#include "tools/report/run_recorder.h"
#include "tools/report/trace_file.h"

namespace g31::cli {
namespace {

/// Prints on the terminal while the program runs, unless the document goes there.
class EchoingRecorder final : public report::RunRecorder {
 public:
  EchoingRecorder(report::RecordWhat what, bool echo) : RunRecorder(what), echo_(echo) {}
  void on_output(std::string_view text) override {
    RunRecorder::on_output(text);
    if (echo_) {
      std::fwrite(text.data(), 1, text.size(), stdout);
    }
  }

 private:
  bool echo_;
};

/// Variables asked for by --print, with a refusal for names the control does not have.
Result<std::vector<std::pair<std::string, runtime::Cell>>, Refusal> read_prints(
    fanuc::Session& session, const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, runtime::Cell>> values;
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

/// Where the result goes: the document, or the variables asked for as lines.
std::optional<Refusal> deliver(const RunOptions& options, const report::RunResult& result,
                               const report::RunRecorder& recorder) {
  if (options.json == "-") {
    const std::string document = run_document(result, recorder);
    std::fwrite(document.data(), 1, document.size(), stdout);
    return std::nullopt;
  }
  for (const auto& [name, value] : result.variables) {
    fmt::print("{} = {}\n", name, value.is_vacant() ? "null" : fmt::format("{}", value.raw()));
  }
  if (options.json.empty()) {
    return std::nullopt;
  }
  const auto problem = write_whole_file(options.json, run_document(result, recorder));
  return problem ? std::optional(refusal(ExitCode::BadUsage, *problem)) : std::nullopt;
}

/// The variables file, where the sheet names one.
std::optional<Refusal> keep_variables(const setup::Job& job, fanuc::Session& session) {
  if (job.control.variables_file.empty()) {
    return std::nullopt;
  }
  const auto problem =
      write_whole_file(job.control.variables_file, variables_text(session.permanent_variables()));
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

}  // namespace

ExitCode run_command(const RunOptions& options) {
  auto prepared = prepare(options);
  if (!prepared) {
    return refuse(prepared.error());
  }
  const setup::Job& job = prepared.value().job;
  Disk disk;
  fanuc::ProgramLibrary library(disk);
  if (const auto wrong = fill_library(library, options)) {
    return refuse(*wrong);
  }
  const auto trace = open_trace(options.trace, job.machine);
  if (!trace) {
    return refuse(trace.error());
  }
  const auto scene = build_scene(job, options.seed);
  if (!scene) {
    return refuse({ExitCode::Setup, setup::render(scene.error())});
  }
  using Keep = report::RecordWhat::Keep;
  EchoingRecorder recorder(
      {options.moves ? Keep::Yes : Keep::No, options.touches ? Keep::Yes : Keep::No},
      options.json != "-");
  machine::MachiningCentre& machine = *scene.value().machine;
  if (trace.value() != nullptr) {
    machine.trace(prepared.value().trace_period_s, *trace.value());
  }
  fanuc::Session session(*prepared.value().profile, library, machine, recorder);
  if (const auto refused = session.configure(job.control); !refused.empty()) {
    return refuse(refusal(ExitCode::Setup, fmt::format("{}", fmt::join(refused, "; "))));
  }
  report::RunResult result;
  result.outcome = session.run(options.budget);
  if (trace.value() != nullptr) {
    if (const auto problem = trace.value()->finish()) {
      return refuse(refusal(ExitCode::BadUsage, *problem));
    }
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
  result.control = prepared.value().profile->name;
  result.seed = options.seed;
  result.variables = values.value();
  result.machine_time_s = machine.time_s();
  result.probe_state = probe_state_of(job);
  if (const auto wrong = deliver(options, result, recorder)) {
    return refuse(*wrong);
  }
  if (const auto wrong = keep_variables(job, session)) {
    return refuse(*wrong);
  }
  return exit_code_of(result.outcome);
}

}  // namespace g31::cli

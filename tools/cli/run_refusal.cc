#include "tools/cli/run_refusal.h"

#include <cstdio>
#include <exception>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/cli/ended_wait.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_inputs.h"
#include "tools/cli/run_page.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/disk/part_file.h"
#include "tools/disk/waiting.h"
#include "tools/report/event_log.h"
#include "tools/report/run_document.h"
#include "tools/session/ending.h"

namespace g31::cli {
namespace {

/// What a run that did not begin tells.
report::RunResult result_of(const RunOptions& options, const session::Refusal& wrong) {
  report::RunResult result;
  RunInputs inputs;
  inputs.add(options);
  result.version = options.version;
  result.exit_code = static_cast<int>(exit_code_of(wrong.ending));
  result.inputs = inputs.files();
  result.program = options.programs.empty() ? std::string() : options.programs.front();
  result.control = options.control;
  result.seed = options.seed;
  result.outcome = outcome_of(wrong);
  return result;
}

/// Writes the document of a run that did not begin.
std::optional<session::Refusal> write_refusal(const RunOptions& options, const std::string& json,
                                              const session::Refusal& wrong) {
  const report::RunResult result = result_of(options, wrong);
  disk::Disk disk;
  const source::SourceMap no_sources(disk);
  runtime::OutputBudget nothing;
  const report::RunRecorder recorder({}, nothing);
  return write_out(json, [&](disk::PartFile& file) {
    report::write_run_document(result, recorder, no_sources, {},
                               [&](std::string_view piece) { file.write(piece); });
  });
}

/// Writes the events of a run that did not begin, its messages and its end, where they take nobody
/// else's place.
std::optional<session::Refusal> write_refusal_events(const RunOptions& options,
                                                     const session::Refusal& wrong) {
  if (auto kept = why_not_replaced("--jsonl", options.jsonl)) {
    return kept;
  }
  const report::RunResult result = result_of(options, wrong);
  disk::Disk disk;
  const source::SourceMap no_sources(disk);
  runtime::OutputBudget nothing;
  const auto events = report::EventLog::create(options.jsonl, no_sources, nothing);
  if (!events) {
    return session::bad_input(events.error());
  }
  events.value()->start(result);
  const auto problem = events.value()->finish(result, 0);
  return problem ? std::optional(session::bad_input(*problem)) : std::nullopt;
}

/// Shows why a run did not begin as its page.
std::optional<session::Refusal> show_refusal(const RunOptions& options,
                                             const session::Refusal& wrong) {
  if (options.watch != nullptr) {
    for (const setup::SetupError& error : wrong.sheet_errors) {
      options.watch->looked(error.file);
    }
  }
  disk::Disk disk;
  const source::SourceMap no_sources(disk);
  return deliver_refusal_page(options, result_of(options, wrong), no_sources);
}

/// Writes the document of a run that did not begin where it takes nobody else's place.
std::optional<session::Refusal> write_refusal_with_care(const RunOptions& options,
                                                        const std::string& json,
                                                        const session::Refusal& wrong) {
  auto kept = why_not_replaced("--json", json);
  return kept ? kept : write_refusal(options, json, wrong);
}

/// The line that every run ends with.
void tell_end(const RunOptions& options, const session::Refusal& wrong) {
  if (options.talk != Talk::Quiet) {
    const std::string status = session::status_name(outcome_of(wrong));
    std::fputs(fmt::format("g31: {}: nothing has run\n", status).c_str(), stderr);
  }
}

/// Where it is told that a run is refused, beside standard error; "": not there.
struct RefusalPlaces {
  std::string json;
  std::string jsonl;
  bool has_page = false;
};

ExitCode tell_in(const RefusalPlaces& places, const RunOptions& options,
                 const session::Refusal& wrong) {
  ExitCode code = refuse(wrong);
  for (const auto& unwritten :
       {places.json.empty() ? std::nullopt : write_refusal_with_care(options, places.json, wrong),
        places.jsonl.empty() ? std::nullopt : write_refusal_events(options, wrong),
        places.has_page ? show_refusal(options, wrong) : std::nullopt}) {
    const bool is_told = unwritten && unwritten->message == wrong.message;
    code = unwritten && !is_told ? refuse(*unwritten) : code;
  }
  return code;
}

ExitCode tell(const RunOptions& options, const session::Refusal& wrong) {
  const ExitCode code = tell_in({options.json, options.jsonl, wants_page(options)}, options, wrong);
  tell_end(options, wrong);
  return code;
}

std::vector<OutputPlace> run_outputs(const RunOptions& options) {
  return {{"--json", options.json, true},         {"--jsonl", options.jsonl, true},
          {"--report", options.report},           {"--trace", options.trace, true},
          {"--readings", options.readings, true}, {"--printer", options.printer}};
}

InputLists inputs_of(const RunOptions& options, const std::vector<std::string>& read) {
  return {options.programs, options.setups, {options.compare}, read};
}

}  // namespace

std::optional<ExitCode> refused_places(const RunOptions& options,
                                       const std::vector<std::string>& read, RunStage stage) {
  const std::vector<OutputPlace> outputs = run_outputs(options);
  const InputLists inputs = inputs_of(options, read);
  const auto wrong =
      stage == RunStage::IsAsked ? wrong_outputs(outputs, inputs) : wrong_place(outputs, inputs);
  if (!wrong) {
    return std::nullopt;
  }
  const auto sound = [&](std::string_view option) { return sound_place(option, outputs, inputs); };
  return tell_in({sound("--json"), stage == RunStage::HasEnded ? "" : sound("--jsonl"),
                  options.watch != nullptr || !sound("--report").empty()},
                 options, *wrong);
}

void tell_usage_error(const RunOptions& options, const std::string& json, const std::string& why) {
  if (const auto unwritten = write_refusal_with_care(options, json, session::bad_input(why))) {
    refuse(*unwritten);
  }
}

ExitCode run_or_tell(const RunOptions& options, const RunWork& work) {
  if (const auto refused = refused_places(options, {}, RunStage::IsAsked)) {
    return *refused;
  }
  const disk::WaitingLimit limit(options.budget.wall_seconds);
  try {
    const auto done = work();
    if (done) {
      return done.value();
    }
    return tell(options, with_ended_wait(done.error()));
  } catch (const std::exception& thrown) {
    return tell(options, refusal_of(thrown));
  }
}

}  // namespace g31::cli

#include "tools/cli/run_refusal.h"

#include <exception>
#include <string_view>
#include <utility>

#include "tools/cli/messages.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/report/run_document.h"

namespace g31::cli {
namespace {

/// How the document of a run that did not begin names why; nullopt: it has no name for it.
std::optional<runtime::Status> status_of(session::Ending ending) {
  switch (ending) {
    case session::Ending::Setup:
      return runtime::Status::Setup;
    case session::Ending::Budget:
      return runtime::Status::Budget;
    case session::Ending::Interrupted:
      return runtime::Status::Interrupted;
    case session::Ending::Defect:
      return runtime::Status::Defect;
    case session::Ending::Completed:
    case session::Ending::Findings:
    case session::Ending::BadInput:
    case session::Ending::Alarm:
    case session::Ending::Collision:
      break;
  }
  return std::nullopt;
}

source::Diagnostic diagnostic_of(const setup::SetupError& error) {
  source::Diagnostic diagnostic;
  diagnostic.code = error.code;
  diagnostic.message = error.message;
  diagnostic.remedy = error.remedy;
  diagnostic.in_sheet = {error.file, error.line, error.column, error.source_line};
  return diagnostic;
}

/// Of the message that a run which has begun would end with; "": its own words say it all.
std::string_view code_of(runtime::Status status) {
  if (status == runtime::Status::Defect) {
    return source::info(source::DiagnosticId::Defect).code;
  }
  if (status == runtime::Status::Interrupted) {
    return source::info(source::DiagnosticId::Interrupted).code;
  }
  return {};
}

runtime::Outcome outcome_of(runtime::Status status, const session::Refusal& wrong) {
  runtime::Outcome outcome;
  outcome.status = status;
  for (const setup::SetupError& error : wrong.sheet_errors) {
    outcome.diagnostics.push_back(diagnostic_of(error));
  }
  if (wrong.sheet_errors.empty()) {
    source::Diagnostic diagnostic;
    diagnostic.message = wrong.message;
    diagnostic.code = code_of(status);
    outcome.diagnostics.push_back(std::move(diagnostic));
  }
  return outcome;
}

ExitCode tell(const RunOptions& options, const session::Refusal& wrong) {
  const ExitCode code = refuse(wrong);
  const auto status = status_of(wrong.ending);
  if (!status || options.json.empty()) {
    return code;
  }
  report::RunResult result;
  result.program = options.programs.empty() ? std::string() : options.programs.front();
  result.control = options.control;
  result.seed = options.seed;
  result.outcome = outcome_of(*status, wrong);
  disk::Disk disk;
  const source::SourceMap no_sources(disk);
  runtime::OutputBudget nothing;
  const report::RunRecorder recorder({}, nothing);
  const auto unwritten = write_out(options.json, [&](disk::PartFile& file) {
    report::write_run_document(result, recorder, no_sources,
                               [&](std::string_view piece) { file.write(piece); });
  });
  return unwritten ? refuse(*unwritten) : code;
}

}  // namespace

ExitCode run_or_tell(const RunOptions& options, const RunWork& work) {
  bool has_begun = false;
  try {
    const auto done = work([&] { has_begun = true; });
    return done ? done.value() : tell(options, done.error());
  } catch (const std::exception& defect) {
    if (has_begun) {
      throw;
    }
    return tell(options, {session::Ending::Defect, defect.what(), {}});
  }
}

}  // namespace g31::cli

#include "tools/cli/refusal_document.h"

#include <filesystem>
#include <new>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/cli/ended_wait.h"
#include "tools/cli/messages.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/report/event_json.h"
#include "tools/session/ending.h"

namespace g31::cli {
namespace {

/// How the document of a run that did not begin names why.
runtime::Status status_of(session::Ending ending) {
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
  return runtime::Status::SyntaxError;  // without an alarm it is called usage
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

std::string document_of(const session::Refusal& wrong, std::string_view schema) {
  disk::Disk disk;
  const source::SourceMap no_sources(disk);
  return document_of(outcome_of(wrong), exit_code_of(wrong.ending), schema, no_sources);
}

}  // namespace

session::Refusal refusal_of(const std::exception& thrown) {
  if (dynamic_cast<const std::bad_alloc*>(&thrown) != nullptr) {
    return {session::Ending::Budget, "there is not enough memory for this work", {}};
  }
  return {session::Ending::Defect, thrown.what(), {}};
}

source::Diagnostic message_of(const session::Refusal& wrong) {
  source::Diagnostic diagnostic;
  diagnostic.message = wrong.message;
  return diagnostic;
}

std::string document_of(const runtime::Outcome& outcome, ExitCode code, std::string_view schema,
                        const source::SourceMap& sources) {
  report::Json document = {{"schema", schema},
                           {"status", session::status_name(outcome)},
                           {"exit_code", static_cast<int>(code)}};
  document["diagnostics"] = report::Json::array();
  for (const source::Diagnostic& message : outcome.diagnostics) {
    document["diagnostics"].push_back(report::diagnostic_json(message, sources));
  }
  return document.dump(1, ' ', false, report::Json::error_handler_t::replace) + "\n";
}

runtime::Outcome outcome_of(const session::Refusal& wrong) {
  runtime::Outcome outcome;
  outcome.status = status_of(wrong.ending);
  for (const setup::SetupError& error : wrong.sheet_errors) {
    outcome.diagnostics.push_back(diagnostic_of(error));
  }
  if (wrong.sheet_errors.empty()) {
    outcome.diagnostics.push_back(message_of(wrong));
    outcome.diagnostics.back().code = code_of(outcome.status);
  }
  return outcome;
}

std::optional<session::Refusal> why_not_replaced(std::string_view option, const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(path, error) || path.ends_with(".json") || path.ends_with(".jsonl") ||
      path.ends_with(".html") || fs::file_size(path, error) == 0) {
    return std::nullopt;
  }
  constexpr std::size_t kHead = 64;
  disk::Disk disk;
  if (disk.read_part(path, 0, kHead).value_or("").find("\"g31.") != std::string::npos) {
    return std::nullopt;
  }
  return session::bad_input(
      fmt::format("{} {}: this file is no document of g31, so it stays as it is", option, path));
}

std::optional<session::Refusal> write_refusal(const session::Refusal& wrong,
                                              const std::string& json, std::string_view schema) {
  auto kept = why_not_replaced("--json", json);
  return kept ? kept : write_out(json, document_of(wrong, schema));
}

ExitCode refuse(const session::Refusal& given, const std::string& json, std::string_view schema) {
  const session::Refusal wrong = with_ended_wait(given);
  const ExitCode code = refuse(wrong);
  if (json.empty() || wrong.ending == session::Ending::Interrupted) {
    return code;  // who interrupts the work wants no file of it
  }
  const auto unwritten = write_refusal(wrong, json, schema);
  const bool is_told = unwritten && unwritten->message == wrong.message;
  return unwritten && !is_told ? refuse(*unwritten) : code;
}

}  // namespace g31::cli

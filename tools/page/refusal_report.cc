#include "interpreter/source/latin_1.h"
#include "tools/page/run_report.h"

namespace g31::page {
namespace {

using runtime::Status;

Verdict why_not(const report::RunResult& result) {
  switch (result.outcome.status) {
    case Status::Setup:
      return {Sign::Broken, "Set-up", "The set-up is not right: nothing ran.", ""};
    case Status::Budget:
      return {Sign::Broken, "Limit reached", "A limit was reached before the program began.", ""};
    case Status::Interrupted:
      return {Sign::Broken, "Interrupted", "It was interrupted before the program began.", ""};
    case Status::Defect:
      return {Sign::Broken, "Defect of g31", "g31 itself has a defect here.", ""};
    case Status::Completed:
    case Status::SyntaxError:
    case Status::Alarm:
    case Status::Collision:
      break;
  }
  return {Sign::Broken, "Not run", "The run could not begin.", ""};
}

std::vector<Finding> refused_findings(const report::RunResult& result,
                                      const source::SourceMap& sources) {
  std::vector<Finding> findings;
  for (const source::Diagnostic& message : result.outcome.diagnostics) {
    findings.push_back({message.severity, message.code, source::as_utf8(message.message),
                        place_at(source::place_of(message, sources)),
                        excerpt_of(message, sources)});
  }
  return findings;
}

}  // namespace

std::string excerpt_of(const source::Diagnostic& message, const source::SourceMap& sources) {
  if (message.severity != source::Severity::Error) {
    return {};
  }
  const std::string text = source::render_text(message, sources);
  return text.substr(text.find('\n') + 1);
}

Report refusal_report(const report::RunResult& result, const source::SourceMap& sources,
                      const std::string& command, Language language) {
  Report report;
  report.language = language;
  report.title = without_folder(result.program);
  report.what = result.control;
  report.verdict = why_not(result);
  report.findings = refused_findings(result, sources);
  report.facts = {
      {std::string(text_of(Word::Program, language)), report.title},
      {std::string(text_of(Word::Seed, language)), std::to_string(result.seed)},
      {std::string(text_of(Word::ExitCode, language)), std::to_string(result.exit_code)},
      {std::string(text_of(Word::Version, language)), result.version},
  };
  report.command = command;
  for (const report::InputFile& file : result.inputs) {
    report.inputs.push_back({file.file, "read by the run", file.sha256});
  }
  runtime::OutputBudget nothing;
  const report::RunRecorder recorder({}, nothing);
  report::write_run_document(result, recorder, sources,
                             [&](std::string_view piece) { report.document += piece; });
  return report;
}

}  // namespace g31::page

#include <algorithm>

#include "interpreter/source/file_system.h"
#include "interpreter/source/readable_text.h"
#include "tools/page/file_names.h"
#include "tools/page/run_report.h"

namespace g31::page {
namespace {

using runtime::Status;

Verdict why_not(const report::RunResult& result, Language language) {
  const auto broken = [language](Word state, Word headline) {
    return Verdict{Sign::Broken, std::string(text_of(state, language)),
                   std::string(text_of(headline, language)), ""};
  };
  switch (result.outcome.status) {
    case Status::Setup:
      return broken(Word::SetUp, Word::SaysSetUpWrong);
    case Status::Budget:
      return broken(Word::StateLimit, Word::SaysLimitBefore);
    case Status::Interrupted:
      return broken(Word::StateInterrupted, Word::SaysInterruptedBefore);
    case Status::Defect:
      return broken(Word::StateDefect, Word::SaysDefect);
    case Status::Completed:
    case Status::SyntaxError:
    case Status::Alarm:
    case Status::Collision:
      break;
  }
  return broken(Word::StateNotRun, Word::SaysNotBegun);
}

std::vector<Finding> refused_findings(const report::RunResult& result,
                                      const source::SourceMap& sources) {
  std::vector<Finding> findings;
  for (const source::Diagnostic& message : result.outcome.diagnostics) {
    findings.push_back(finding_of(message, FileNames(), sources));
  }
  return findings;
}

}  // namespace

void add_listings_of_errors(const std::vector<source::Diagnostic>& messages, const FileNames& names,
                            const source::SourceMap& sources, std::vector<Listing>& listings) {
  for (const source::Diagnostic& message : messages) {
    const std::string path = message.severity == source::Severity::Error
                                 ? sources.show(message.where).file
                                 : std::string();
    const std::string name = names.of(path);
    if (path.empty() || std::ranges::find(listings, name, &Listing::file) != listings.end()) {
      continue;
    }
    if (const auto text = source::read_program(sources.files(), path)) {
      listings.push_back({name, source::readable_text(*text), {}, {}});
    }
  }
}

Finding finding_of(const source::Diagnostic& message, const FileNames& names,
                   const source::SourceMap& sources) {
  Finding finding;
  finding.severity = message.severity;
  finding.code = message.code;
  finding.text = source::readable_text(message.message);
  finding.place = names.at(source::place_of(message, sources));
  if (message.severity == source::Severity::Error) {
    finding.excerpt = source::excerpt_of(message, sources);
  }
  if (!message.remedy.empty()) {
    finding.remarks.push_back(source::readable_text(message.remedy));
  }
  for (const source::Note& note : message.notes) {
    finding.remarks.push_back(source::text_of(note, sources));
  }
  return finding;
}

Report refusal_report(const report::RunResult& result, const source::SourceMap& sources,
                      const std::string& command, Language language) {
  Report report;
  report.language = language;
  report.title = without_folder(result.program);
  report.what = result.control;
  report.verdict = why_not(result, language);
  report.findings = refused_findings(result, sources);
  report.facts = {
      {std::string(text_of(Word::Program, language)), report.title},
      {std::string(text_of(Word::Seed, language)), std::to_string(result.seed)},
      {std::string(text_of(Word::ExitCode, language)), std::to_string(result.exit_code)},
      {std::string(text_of(Word::Version, language)), result.version},
  };
  report.command = command;
  add_listings_of_errors(result.outcome.diagnostics, FileNames(), sources, report.listings);
  for (const report::InputFile& file : result.inputs) {
    report.inputs.push_back(
        {file.file, std::string(text_of(Word::InputRead, language)), file.sha256});
  }
  runtime::OutputBudget nothing;
  const report::RunRecorder recorder({}, nothing);
  report::write_run_document(result, recorder, sources, {},
                             [&](std::string_view piece) { report.document += piece; });
  return report;
}

}  // namespace g31::page

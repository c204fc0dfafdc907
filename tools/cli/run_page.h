#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/cli/run_result.h"
#include "tools/page/other_reports.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// Whether somebody wants the run as a page: in a file, or to watch it.
inline bool wants_page(const RunOptions& options) {
  return !options.report.empty() || options.watch != nullptr;
}

/// Why no page can be made, whatever the work will come to; nullopt: it can.
/// @param wanted  what the user knows it by
std::optional<session::Refusal> why_no_page(std::string_view wanted);
/// The same for --report, and why its file cannot be written; nullopt where nobody wants it, too.
std::optional<session::Refusal> wrong_report(const std::string& report);

/// What --lang has to say for a language; "": nothing.
std::string language_given(page::Language language);

/// The other run of --compare.  @returns why it cannot be shown
Result<page::OtherRun, session::Refusal> compared_run(const std::string& path,
                                                      const setup::Job& job);

/// Writes the report.  @returns why it could not be written
std::optional<session::Refusal> deliver_page(const OpenedRun& opened,
                                             const report::RunResult& result);

/// The same of a run that did not begin.
std::optional<session::Refusal> deliver_refusal_page(const RunOptions& options,
                                                     const report::RunResult& result,
                                                     const source::SourceMap& sources);

/// Files that a page tells its reader of, with their hashes; an empty path is none.
std::vector<page::Input> page_inputs(const std::vector<std::string>& paths);

/// The text of a page; error: what it is made of is not there.
Result<std::string, session::Refusal> page_text(const page::Report& report);

/// Writes a page.  @returns why it could not be written
std::optional<session::Refusal> write_page(const std::string& path, const page::Report& report);

}  // namespace g31::cli

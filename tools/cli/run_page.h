#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/cli/run_result.h"
#include "tools/page/other_reports.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// Why --report cannot be done, whatever the work will come to; nullopt: it can, or nobody wants
/// it.
std::optional<session::Refusal> wrong_report(const std::string& report);

/// Writes the report.  @returns why it could not be written
std::optional<session::Refusal> deliver_page(const OpenedRun& opened,
                                             const report::RunResult& result);

/// Files that a page tells its reader of, with their hashes.
std::vector<page::Input> page_inputs(const std::vector<std::string>& paths);

/// Writes a page.  @returns why it could not be written
std::optional<session::Refusal> write_page(const std::string& path, const page::Report& report);

}  // namespace g31::cli

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/interruption.h"
#include "tools/cli/exit_code.h"
#include "tools/page/language.h"

namespace g31::cli {

/// What the command line of `g31 study` says.
struct StudyOptions {
  std::string study;   ///< the study file; "" with --merge
  std::string json;    ///< file, "-" for standard output, "" for none
  std::string csv;     ///< the same
  std::string svg;     ///< file of the drawing of [evaluation], "" for none
  std::string report;  ///< HTML file, "" for none
  page::Language language = page::Language::English;  ///< of the report and the drawing
  std::string version;                                ///< of g31
  std::string shard;                                  ///< "i/n", "" for all
  std::vector<std::string> merge;
  std::size_t threads = 0;             ///< 0: one a core
  std::optional<std::size_t> repeats;  ///< in the place of the study's
  std::optional<std::uint64_t> seed;   ///< the same
  bool is_quiet = false;               ///< no progress
  const runtime::Interruption* interruption = nullptr;
};

/// Runs a study, or puts shards of one together, and reports.
/// @returns the highest exit code of its runs
ExitCode study_command(const StudyOptions& options);

}  // namespace g31::cli

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "interpreter/runtime/interruption.h"
#include "tools/cli/exit_code.h"
#include "tools/evaluate/evaluation.h"
#include "tools/page/language.h"

namespace g31::cli {

/// Of a file that is evaluated: some four million rows.
inline constexpr std::uint64_t kMostDataBytes = 256'000'000;

/// What the command line of `g31 evaluate` says.
struct EvaluateOptions {
  std::string kind;
  std::string file;
  std::string json;  ///< file, "-" for standard output, "" for none
  bool has_curves = false;
  std::string svg;                                    ///< file of the drawing, "" for none
  std::string report;                                 ///< HTML file, "" for none
  page::Language language = page::Language::English;  ///< of the report and the drawing
  std::string version;                                ///< of g31
  std::string magnify;  ///< how many times it enlarges errors; "": so that they are seen
  std::vector<std::string> columns;                 ///< "X=x_act"
  std::string unit;                                 ///< "" for mm
  std::map<evaluate::OptionId, std::string> given;  ///< options that only some kinds know
  double max_time_s = 600.0;                        ///< wall seconds
  std::uint64_t max_output = 256'000'000;           ///< bytes of all that is written, together
  bool is_quiet = false;                            ///< no progress
  const runtime::Interruption* interruption = nullptr;
};

/// Evaluates a recorded motion or readings and reports.
ExitCode evaluate_command(const EvaluateOptions& options);

}  // namespace g31::cli

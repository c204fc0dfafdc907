#pragma once

#include <string>

#include "interpreter/runtime/interruption.h"
#include "tools/cli/exit_code.h"
#include "tools/page/language.h"

namespace g31::cli {

/// What `g31 judge` was asked for.
struct JudgeOptions {
  std::string plan;      ///< a plan.json
  std::string results;   ///< a file, "-" or a serial line
  double wait_s = 60.0;  ///< of silence on a line, until what has not come is missing
  std::string json;      ///< where the document goes; "": nowhere
  std::string report;    ///< the page; "": none
  page::Language language = page::Language::English;
  std::string version;  ///< of g31
  const runtime::Interruption* interruption = nullptr;
};

/// Compares what a program printed with its plan.
ExitCode judge_command(const JudgeOptions& options);

}  // namespace g31::cli

#pragma once

#include <optional>
#include <string>

#include "interpreter/runtime/outcome.h"
#include "tools/cli/exit_code.h"
#include "tools/page/language.h"

namespace g31::cli {

/// What the command line of `g31 plan` says.
struct PlanOptions {
  std::string product;
  std::string stock;   ///< a file, "X,Y,Z" or "box"
  std::string folder;  ///< gets the plan
  std::string control;
  std::string setup;
  std::optional<double> tolerance_mm;
  std::string as_machined;
  std::string json;  ///< another place for plan.json; "-" for standard output, "" for none
  bool by_points = false;
  bool is_quiet = false;                              ///< no progress
  page::Language language = page::Language::English;  ///< of the page
  std::string version;                                ///< of g31
  const runtime::Interruption* interruption = nullptr;
};

/// Plans the inspection of a part, proves the program and writes it with its sheet, the plan and a
/// page, all of them or none.
ExitCode plan_command(const PlanOptions& options);

}  // namespace g31::cli

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "tools/cli/exit_code.h"

namespace g31::cli {

/// What the command line of `g31 run` says.
struct RunOptions {
  std::vector<std::string> programs;
  std::vector<std::string> setups;
  std::string control;
  std::vector<std::string> libraries;
  std::vector<std::string> assignments;
  std::vector<std::string> prints;
  std::string json;  ///< file, "-" for standard output, "" for none
  std::string trace;               ///< file of sampled positions, "" for none
  std::string trace_period = "1ms";  ///< as parse_duration takes it
  bool moves = false;
  bool touches = false;
  std::uint64_t seed = 0;
  runtime::Budget budget;
};

/// Runs a program and reports: standard output what it prints, standard error what is wrong.
ExitCode run_command(const RunOptions& options);

}  // namespace g31::cli

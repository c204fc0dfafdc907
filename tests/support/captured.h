#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/cli/exit_code.h"

namespace g31::testing {

/// What a command left.
struct CommandOutput {
  int exit_code = -1;
  std::string out;
  std::string errors;
};

/// Does a command in this process.
CommandOutput captured(const std::function<cli::ExitCode()>& command);

/// Does a command line of g31 in this process.
/// @param words    behind the name of the program
/// @param version  that it is told
CommandOutput g31(const std::vector<std::string>& words, const std::string& version = "7.8.9");

}  // namespace g31::testing

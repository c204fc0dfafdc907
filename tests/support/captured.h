#pragma once

#include <functional>
#include <string>

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

}  // namespace g31::testing

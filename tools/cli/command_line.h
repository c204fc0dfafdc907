#pragma once

#include <string>

#include "tools/cli/exit_code.h"

namespace g31::cli {

/// Does what the words of a command line ask for.
/// @param version  of the program, for --version
ExitCode run_command_line(int argc, const char* const* argv, const std::string& version);

}  // namespace g31::cli

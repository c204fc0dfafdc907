#pragma once

#include <string>

namespace g31::cli {

/// The last part of each --help: every exit code and what it says.
std::string exit_code_help();

}  // namespace g31::cli

#pragma once

#include <string>
#include <string_view>

namespace g31::cli {

/// What the last part of each --help begins with.
inline constexpr std::string_view kExitCodesHead = "Exit codes:\n";

/// That part: the exit codes that a command can end with, and what they say.
/// @param command  "": any of them
std::string exit_code_help(std::string_view command);

}  // namespace g31::cli

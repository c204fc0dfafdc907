#pragma once

#include <string>
#include <string_view>

#include "tools/cli/command_words.h"

namespace g31::cli {

/// A script that lets a shell complete commands, options, file names and words with a few choices.
/// @param shell  one of completion_shells()
std::string completion_script(const ProgramWords& words, std::string_view shell);

/// bash, fish, zsh.
std::vector<std::string> completion_shells();

}  // namespace g31::cli

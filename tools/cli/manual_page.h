#pragma once

#include <string>
#include <string_view>

#include "tools/cli/command_words.h"

namespace g31::cli {

/// A page of the manual, section 1, in the language of man(7).
/// @param command  "": the page of the program, which names its commands
std::string manual_page(const ProgramWords& words, std::string_view command);

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/command_words.h"

namespace CLI {
class App;
}

namespace g31::cli {

/// What a command line that CLI11 was told about takes; what is hidden from --help is left out.
ProgramWords read_command_words(const CLI::App& app, const std::string& version);

}  // namespace g31::cli

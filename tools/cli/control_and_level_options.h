#pragma once

#include <string>

#include "interpreter/source/diagnostic.h"

namespace CLI {
class App;
}

namespace g31::cli {

// Options that several commands have, alike in each but for what they say.

/// --control NAME
void add_control_option(CLI::App& command, std::string& control, const std::string& text);

/// --fail-on error|warning|note
void add_fail_on_option(CLI::App& command, source::Severity& fail_on, const std::string& text);

/// --quiet, of a command that has none of its own
void add_quiet_option(CLI::App& command, bool& is_quiet);

}  // namespace g31::cli

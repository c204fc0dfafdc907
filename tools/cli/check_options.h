#pragma once

#include <string>

#include "tools/cli/check_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `check`; parsing fills `options`.
void add_check_options(CLI::App& check, CheckOptions& options);

/// Examples for the help text.
std::string check_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/check_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `check` and its options; parsing fills `options`.
CLI::App* add_check_command(CLI::App& app, CheckOptions& options);

/// Examples for the help text.
std::string check_examples();

}  // namespace g31::cli

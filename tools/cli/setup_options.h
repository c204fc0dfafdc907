#pragma once

#include <string>

#include "tools/cli/setup_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `setup` and its options; parsing fills `options`.
CLI::App* add_setup_command(CLI::App& app, SetupOptions& options);

/// Examples for the help text.
std::string setup_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/setup_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `setup`; parsing fills `options`.
void add_setup_options(CLI::App& setup, SetupOptions& options);

/// Examples for the help text.
std::string setup_examples();

}  // namespace g31::cli

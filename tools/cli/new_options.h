#pragma once

#include <string>

#include "tools/cli/new_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `new`; parsing fills `options`.
void add_new_options(CLI::App& command, NewOptions& options);

/// Examples for the help text.
std::string new_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/new_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `new` and its options; parsing fills `options`.
CLI::App* add_new_command(CLI::App& app, NewOptions& options);

/// Examples for the help text.
std::string new_examples();

}  // namespace g31::cli

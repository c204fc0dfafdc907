#pragma once

#include <string>

#include "tools/cli/view_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `view` and its options; parsing fills `options`.
CLI::App* add_view_command(CLI::App& app, ViewOptions& options);

/// Examples for the help text.
std::string view_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/view_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `view`; parsing fills `options`.
void add_view_options(CLI::App& view, ViewOptions& options);

/// Examples for the help text.
std::string view_examples();

}  // namespace g31::cli

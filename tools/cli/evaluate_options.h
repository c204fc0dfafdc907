#pragma once

#include <string>

#include "tools/cli/evaluate_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `evaluate`; parsing fills `options`.
void add_evaluate_options(CLI::App& command, EvaluateOptions& options);

/// Examples for the help text.
std::string evaluate_examples();

}  // namespace g31::cli

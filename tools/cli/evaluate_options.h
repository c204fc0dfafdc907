#pragma once

#include <string>

#include "tools/cli/evaluate_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `evaluate` and its options; parsing fills `options`.
CLI::App* add_evaluate_command(CLI::App& app, EvaluateOptions& options);

/// Examples for the help text.
std::string evaluate_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/plan_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `plan` and its options; parsing fills `options`.
CLI::App* add_plan_command(CLI::App& app, PlanOptions& options);

/// Examples for the help text.
std::string plan_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/plan_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `plan`; parsing fills `options`.
void add_plan_options(CLI::App& command, PlanOptions& options);

/// Examples for the help text.
std::string plan_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/judge_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `judge`; parsing fills `options`.
void add_judge_options(CLI::App& command, JudgeOptions& options);

/// Examples for the help text.
std::string judge_examples();

}  // namespace g31::cli

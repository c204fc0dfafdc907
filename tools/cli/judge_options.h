#pragma once

#include <string>

#include "tools/cli/judge_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `judge` and its options; parsing fills `options`.
CLI::App* add_judge_command(CLI::App& app, JudgeOptions& options);

/// Examples for the help text.
std::string judge_examples();

}  // namespace g31::cli

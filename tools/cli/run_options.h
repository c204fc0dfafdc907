#pragma once

#include <string>

#include "tools/cli/run_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of every subcommand that runs a program.
void add_program_options(CLI::App& command, RunOptions& options);

/// --expect.
void add_expect_option(CLI::App& command, RunOptions& options);

/// Adds `run` and its options; parsing fills `options`.
CLI::App* add_run_command(CLI::App& app, RunOptions& options);

/// Examples for the help text.
std::string run_examples();

}  // namespace g31::cli

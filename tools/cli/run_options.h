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

/// The options of `run`; parsing fills `options`.
void add_run_options(CLI::App& run, RunOptions& options);

/// Examples for the help text.
std::string run_examples();

}  // namespace g31::cli

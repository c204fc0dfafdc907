#include "tests/support/run_arguments.h"

#include <CLI/CLI.hpp>

#include "tools/cli/run_options.h"

namespace g31::testing {

Result<cli::RunOptions, std::string> parsed_run_options(const std::vector<std::string>& words) {
  CLI::App app;
  cli::RunOptions options;
  cli::add_run_options(*app.add_subcommand("run"), options);
  std::vector<const char*> arguments = {"g31", "run"};
  for (const std::string& word : words) {
    arguments.push_back(word.c_str());
  }
  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) {
    return std::string(error.what());
  }
  return options;
}

}  // namespace g31::testing

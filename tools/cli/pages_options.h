#pragma once

#include <string>

namespace CLI {
class App;
}

namespace g31::cli {

/// What the command line of `g31 completion` and `g31 manual` says.
struct PagesOptions {
  std::string shell;
  std::string command;
};

void add_completion_options(CLI::App& command, PagesOptions& options);
std::string completion_examples();

void add_manual_options(CLI::App& command, PagesOptions& options);
std::string manual_examples();

}  // namespace g31::cli

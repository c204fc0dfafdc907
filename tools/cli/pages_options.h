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

CLI::App* add_completion_command(CLI::App& app, PagesOptions& options);
std::string completion_examples();

CLI::App* add_manual_command(CLI::App& app, PagesOptions& options);
std::string manual_examples();

}  // namespace g31::cli

#include "tools/cli/pages_options.h"

#include <CLI/CLI.hpp>

#include "tools/cli/completion.h"

namespace g31::cli {

void add_completion_options(CLI::App& command, PagesOptions& options) {
  command.add_option("SHELL", options.shell, "the shell")
      ->required()
      ->check(CLI::IsMember(completion_shells()));
}

std::string completion_examples() {
  return "Examples (an installed g31 has these files already):\n"
         "  source <(g31 completion bash)\n"
         "  g31 completion zsh > ~/.zfunc/_g31\n"
         "  g31 completion fish > ~/.config/fish/completions/g31.fish\n\n";
}

void add_manual_options(CLI::App& command, PagesOptions& options) {
  command.add_option("COMMAND", options.command, "of this command; without it of g31");
}

std::string manual_examples() {
  return "Examples (an installed g31 has these pages already: man g31-run):\n"
         "  g31 manual run | man -l -\n"
         "  g31 manual > g31.1\n\n";
}

}  // namespace g31::cli

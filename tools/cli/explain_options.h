#pragma once

#include <string>

#include "tools/cli/explain_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `explain` and its options; parsing fills `options`.
CLI::App* add_explain_command(CLI::App& app, ExplainOptions& options);

/// Whether a word of `explain` is where its document goes: no topic has such a name.
bool is_file_of_explain(const std::string& word);

/// Examples for the help text.
std::string explain_examples();

}  // namespace g31::cli

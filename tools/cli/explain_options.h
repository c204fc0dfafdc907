#pragma once

#include <string>

#include "tools/cli/explain_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `explain`; parsing fills `options`.
void add_explain_options(CLI::App& explain, ExplainOptions& options);

/// Whether a word of `explain` is where its document goes: no topic has such a name.
bool is_file_of_explain(const std::string& word);

/// Examples for the help text.
std::string explain_examples();

}  // namespace g31::cli

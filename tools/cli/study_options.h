#pragma once

#include <string>

#include "tools/cli/study_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// The options of `study`; parsing fills `options`.
void add_study_options(CLI::App& study, StudyOptions& options);

/// Examples for the help text.
std::string study_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tools/cli/study_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Adds `study` and its options; parsing fills `options`.
CLI::App* add_study_command(CLI::App& app, StudyOptions& options);

/// Examples for the help text.
std::string study_examples();

}  // namespace g31::cli

#pragma once

#include <string>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/study_command.h"

namespace g31::testing {

/// The content of a file; a test fails where there is none.
std::string text_of_file(const std::string& path);

/// What `g31 study` left.
using StudyOutput = CommandOutput;

/// Runs the command in this process.
StudyOutput run_study(const cli::StudyOptions& options);

/// Runs it with the document on standard output.
StudyOutput study_document(cli::StudyOptions options);

}  // namespace g31::testing

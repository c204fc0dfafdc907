#pragma once

#include "tools/cli/command_words.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/pages_options.h"

namespace g31::cli {

/// Does what `g31 completion` was asked for.
ExitCode completion_command(const ProgramWords& words, const PagesOptions& options);

/// Does what `g31 manual` was asked for.
ExitCode manual_command(const ProgramWords& words, const PagesOptions& options);

/// Answers --version: a line, or the document g31.version/1.
ExitCode version_command(const ProgramWords& words, bool is_json);

}  // namespace g31::cli

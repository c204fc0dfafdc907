#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tools/session/ending.h"

namespace g31::cli {

/// Rows of exit_codes.def.
enum class ExitCode {
#define EXIT_CODE(name, code, text) name = (code),
#include "tools/cli/exit_codes.def"
};

struct ExitCodeRow {
  ExitCode code;
  std::string_view text;
};

std::span<const ExitCodeRow> exit_codes();

/// Those that a command can end with.
/// @param command  "": any of them
std::vector<ExitCodeRow> exit_codes_of(std::string_view command);

/// What a run that came to this returns to the shell.
ExitCode exit_code_of(session::Ending ending);

}  // namespace g31::cli

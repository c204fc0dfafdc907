#pragma once

#include <string>

#include "interpreter/source/diagnostic.h"
#include "tools/cli/exit_code.h"
#include "tools/session/prepare.h"

namespace g31::cli {

/// What the command line of `g31 setup` says.
struct SetupOptions : session::Request {
  std::string json = {};  ///< path of the document, "-" for standard output, "" for none
  source::Severity fail_on = source::Severity::Warning;  ///< lowest level that makes exit code 1
};

/// Prints what is wrong with set-up sheets, against a program where one is given, without running
/// it.
ExitCode setup_command(const SetupOptions& options);

}  // namespace g31::cli

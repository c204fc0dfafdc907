#pragma once

#include <string>

#include "tools/cli/exit_code.h"
#include "tools/cli/run_command.h"

namespace g31::cli {

/// What the command line of `g31 view` says.
struct ViewOptions {
  RunOptions run;
  std::string json;                                     ///< for its address; "": none
  int port = 0;                                         ///< 0: any that is free
  const runtime::Interruption* interruption = nullptr;  ///< which ends it
};

/// Serves the page of a run at this computer alone, and runs the program anew whenever a file that
/// the run depends on is saved.  Its address is one line on standard output, or a document where
/// --json wants one; what is wrong with a run goes to standard error.  It lasts until it is
/// interrupted; nothing else is written.
ExitCode view_command(const ViewOptions& options);

}  // namespace g31::cli

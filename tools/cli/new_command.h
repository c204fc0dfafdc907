#pragma once

#include <string>

#include "tools/cli/exit_code.h"

namespace g31::cli {

/// What the command line of `g31 new` says.
struct NewOptions {
  std::string folder = {};
  std::string control = {};  ///< "" for the default
  std::string json = {};     ///< where the document goes; "": nowhere
};

/// Makes a folder with a program of a control that runs as it is, its set-up sheet, a file for CI
/// and a README.  Where one of these files is there, nothing is changed.
ExitCode new_command(const NewOptions& options);

}  // namespace g31::cli

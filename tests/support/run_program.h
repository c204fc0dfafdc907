#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.h"
#include "tools/cli/run_command.h"

// One place compiles what a document is made of and read by.
extern template class nlohmann::basic_json<>;

namespace g31::testing {

/// The content of a file; empty where there is none.
std::string text_of(const std::string& path);

/// What `g31 run` left: exit code, document (null when none was written) and standard error.
struct RunOutput {
  int exit_code = -1;
  nlohmann::json document;
  std::string errors;
};

/// Runs the command in this process; the document goes through a file in a folder of its own.
RunOutput run_program(cli::RunOptions options);

}  // namespace g31::testing

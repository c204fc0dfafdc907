#pragma once

#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/cli/run_command.h"

namespace g31::testing {

/// What `g31 run` takes from these words behind it, or why it does not.
Result<cli::RunOptions, std::string> parsed_run_options(const std::vector<std::string>& words);

}  // namespace g31::testing

#pragma once

#include <string>
#include <vector>

#include "tools/setup/job.h"

namespace g31::setup {

/// Files that a job is read from, or that it names to be read or saved.
std::vector<std::string> files_of(const Job& job);

}  // namespace g31::setup

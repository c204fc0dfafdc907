#pragma once

#include <string>
#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/analysis/program_set.h"

namespace g31::analysis {

/// What can be said of the programs of one file without running them, in the order of the text.
/// @param path  a file that was added to the programs
std::vector<Finding> static_findings(ProgramSet& programs, const std::string& path);

}  // namespace g31::analysis

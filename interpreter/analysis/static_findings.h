#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/analysis/program_set.h"

namespace g31::analysis {

/// What can be said of the programs of one file without running them, in the order of the text.
/// @param path  a file that was added to the programs
std::vector<Finding> static_findings(ProgramSet& programs, const std::string& path);

/// What can be said of the definition files that every run of the programs begins with, by the
/// names of the files; those without findings are left out.
std::map<std::string, std::vector<Finding>> definition_findings(ProgramSet& programs);

}  // namespace g31::analysis

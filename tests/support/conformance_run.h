#pragma once

#include <string>
#include <vector>

#include "tests/support/conformance_file.h"

// Runs one case of a conformance file and holds what came of it against its expectations.

namespace g31::testing {

/// The names of the case files in a folder, without ending.
std::vector<std::string> case_files(const std::string& folder);

/// Runs a case on a control and expects what it says.
/// @param path   of the case's file, for messages
/// @param place  the case in words, for messages
void expect_case_holds(const ConformanceCase& test, const std::string& control,
                       const std::string& program, const std::string& path,
                       const std::string& place);

}  // namespace g31::testing

#pragma once

#include <vector>

#include "tools/setup/document.h"

namespace g31::setup {

/// Where lines of a sheet are comments that look like a variable with its value, `#500 = 3.0`: TOML
/// wants such a name in quotes.  None in a document with texts of several lines.
std::vector<Location> lost_variables_in(const Document& document);

}  // namespace g31::setup

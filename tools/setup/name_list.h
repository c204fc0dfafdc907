#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"

namespace g31::setup {

/// A range written by mistake must not fill the memory.
inline constexpr std::size_t kMostNames = 100000;

/// The names of `--print`: a comma list with ranges, `#100-#149,#5061,_OVR[0]-_OVR[19]`.  Commas
/// and minus signs inside square brackets do not split.
///
/// A range runs over the one number in which its two names differ.  Names come in their one
/// spelling (variable_name.h), in the order given, each once.
///
/// Error: one line that says what is wrong: an empty or unknown name, a range of two different
/// kinds of names, a range that runs backwards, more than kMostNames names.
Result<std::vector<std::string>, std::string> parse_name_list(std::string_view text);

}  // namespace g31::setup

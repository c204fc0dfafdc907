#pragma once

#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::setup {

/// A time as the command line takes it: `182.32us`, `4ms`, `0.5s`, or plain seconds; > 0, s.
///
/// Error: one line that says what is wrong and what would be right.
Result<double, std::string> parse_duration(std::string_view text);

}  // namespace g31::setup

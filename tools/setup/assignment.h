#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::setup {

/// `--set NAME=VALUE`: a variable before the start.
struct Assignment {
  std::string name;             ///< in its one spelling, see variable_name.h
  std::optional<double> value;  ///< finite; none is null
};

/// Takes `#500=1.5`, `R1=2`, `_OVR[0]=0` apart; an empty VALUE is null.  Spaces around both sides
/// do not count, a decimal point is a point whatever the locale.
///
/// Error: one line that says what is wrong and what would be right.
Result<Assignment, std::string> parse_assignment(std::string_view text);

}  // namespace g31::setup

#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::session {

/// The non-volatile variables of a control as text: one `#500=1.5` a line, rising.
std::string variables_text(const std::map<std::string, double>& variables);

/// Reads such a text; blank lines and lines that begin with `;` do not count.
/// @returns the variables, or the first line that is none of these
Result<std::map<std::string, std::optional<double>>, std::string> parse_variables_text(
    std::string_view text);

}  // namespace g31::session

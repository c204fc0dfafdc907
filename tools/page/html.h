#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace g31::page {

/// A text as HTML shows it: it is never markup.
/// @param bytes  UTF-8, and as_valid_utf_8() where it is not; control characters but tab and line
///     break are left out
std::string escaped(std::string_view bytes);

enum class ShowSign : unsigned char { WhereNegative, Always };

/// A number with fixed decimals and a real minus sign; a dash where there is none.  What rounds to
/// 0 has no sign.
std::string number(const std::optional<double>& value, int decimals,
                   ShowSign sign = ShowSign::WhereNegative);

/// A length in mm as micrometres, one decimal, with its sign.
std::string micrometres(const std::optional<double>& value_mm);

/// JSON text that may stand in a script element.
std::string json_for_script(std::string_view json);

}  // namespace g31::page

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

/// The same with two significant digits at least, so that what is small is no 0; still smaller as
/// "4.2e−12".
std::string significant(const std::optional<double>& value, int decimals,
                        ShowSign sign = ShowSign::WhereNegative);

/// The fewest decimals, from some upwards, with which a value and its limit read differently; as
/// they were where nothing tells them apart.
int decimals_apart(double value, double limit, int decimals);

inline constexpr double kUmPerMm = 1000.0;

/// A length in mm as micrometres, one decimal, with its sign.
std::string micrometres(const std::optional<double>& value_mm);

/// JSON text that may stand in a script element.
std::string json_for_script(std::string_view json);

}  // namespace g31::page

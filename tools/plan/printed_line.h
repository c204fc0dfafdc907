#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace g31::plan {

/// A value as a program printed it, with the name before it.
struct PrintedValue {
  std::string_view name;
  double value = 0.0;  ///< mm, at most kLongestMm
};

/// Whether a line carries no results: empty, or `%` or `;` comes first.
bool is_passed_over(std::string_view line);

/// Pairs of a name and a number, blanks or one `=` between them.  A control that prints zeros as
/// blanks has them between the sign and the digits too (DPRNT with PRT 0).  Numbers are digits with
/// at most one point: no exponents, no NaN, nothing behind.
/// @returns nullopt: it does not read so from end to end
std::optional<std::vector<PrintedValue>> printed_values(std::string_view line);

/// The words of a line, whatever stands between them.
std::vector<std::string_view> words_of(std::string_view line);

}  // namespace g31::plan

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace g31::evaluate {

/// A field of a row without blanks and quotes around it.
std::string_view bare(std::string_view field);

/// Whether a field stands in double quotes, blanks apart.
bool is_quoted(std::string_view field);

/// Where the field that begins at a place ends: at the next separator that is not in its quotes, or
/// at the end of the line.
std::size_t field_end(std::string_view line, std::size_t begin, char separator);

/// The bare fields of a line.
std::vector<std::string_view> fields_of(std::string_view line, char separator);

/// A text as a field that `fields_of` takes for one.
std::string as_field(std::string_view text, char separator);

/// The number that a bare field is, infinite where it is beyond all numbers; nullopt: it is none.
std::optional<double> number_in(std::string_view field);

/// The same where the point may be a comma.
std::optional<double> number_with_comma_in(std::string_view field);

}  // namespace g31::evaluate

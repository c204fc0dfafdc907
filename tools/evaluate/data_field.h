#pragma once

#include <optional>
#include <string_view>

namespace g31::evaluate {

/// A field of a row without blanks and quotes around it.
std::string_view bare(std::string_view field);

/// The number that a bare field is, infinite where it is beyond all numbers; nullopt: it is none.
std::optional<double> number_in(std::string_view field);

/// The same where the point may be a comma.
std::optional<double> number_with_comma_in(std::string_view field);

}  // namespace g31::evaluate

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/statements.h"
#include "machine/base/result.h"

namespace g31::fanuc {

/// A piece of a DPRNT or BPRNT format: literal text, or a variable with its places.
struct OutputItem {
  std::string text;  ///< literal; empty for a variable
  std::int32_t variable = -1;
  int integer_places = 0;  ///< DPRNT only
  int decimals = 0;
};

/// Reads the text between the outer brackets: letters, digits and signs as they are, `*` a space,
/// blanks dropped, `#v[cd]` or `#v[d]` a variable (MB-237 to MB-239).
/// @returns the items, or why the format is none
Result<std::vector<OutputItem>, std::string> parse_output_format(std::string_view text);

/// What the rule forbids in a format of DPRNT; nullopt: nothing.
std::optional<std::string> refused_by(const OutputRule& rule, const std::vector<OutputItem>& items);

/// A number as DPRNT prints it: sign, integer places, point, decimals; rounded half away from zero.
/// @param integer_places, decimals  0..9 each
std::string decimal_text(double value, int integer_places, int decimals, const OutputStyle& style);

/// Whether DPRNT prints a number without its highest digits.
bool cuts_digits(double value, const OutputItem& item, const OutputStyle& style);

/// A number as BPRNT sends it: round(value * 10^decimals) as four bytes, highest first; nullopt
/// when it does not fit 32 bits.
std::optional<std::string> binary_text(double value, int decimals);

}  // namespace g31::fanuc

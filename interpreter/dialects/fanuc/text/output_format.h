#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"

namespace g31::fanuc {

enum class HasFormat { No, Yes };

enum class OutputStatement : std::int32_t {
#define OUTPUT_STATEMENT(name, has_format, text) name,
#include "interpreter/dialects/fanuc/vocabulary/statements.def"
#undef OUTPUT_STATEMENT
};

/// One row of statements.def.
struct OutputStatementInfo {
  std::string_view name;
  HasFormat has_format;
  std::string_view text;
};

/// All rows.
std::span<const OutputStatementInfo> output_statements();

const OutputStatementInfo& info(OutputStatement statement);

/// The statement of this name or of its first two letters, upper case.
std::optional<OutputStatement> find_output_statement(std::string_view name);

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

/// How a control writes numbers (profile.h and parameter 6001).
struct OutputStyle {
  enum class LeadingZeros { Blank, Omit };  ///< 6001.1 PRT = 0, 1
  enum class Overflow { Cut, Widen };       ///< digits beyond the integer places (MB-243, MB-362)
  enum class PlusSign { Blank, Omit };  ///< the column of a positive sign with LeadingZeros::Blank
  LeadingZeros leading_zeros = LeadingZeros::Blank;
  Overflow overflow = Overflow::Cut;
  PlusSign plus_sign = PlusSign::Blank;
};

/// What a control prints and what it refuses (MB-239, MB-361, MB-373, MB-374).
struct OutputRule {
  OutputStyle style;         ///< of DPRNT with 6001.1 = 0
  bool needs_popen = false;  ///< DPRNT and BPRNT without POPEN are an alarm
  int fewest_digits = 0;     ///< integer places and decimals of one variable, DPRNT
  int most_digits = 8;
  int most_variables = 0;  ///< of one statement; 0: any
};

/// What the rule forbids in a format of DPRNT; nullopt: nothing.
std::optional<std::string> refused_by(const OutputRule& rule, const std::vector<OutputItem>& items);

/// A number as DPRNT prints it: sign, integer places, point, decimals; rounded half away from zero.
/// @param integer_places, decimals  0..9 each
std::string decimal_text(double value, int integer_places, int decimals, const OutputStyle& style);

/// A number as BPRNT sends it: round(value * 10^decimals) as four bytes, highest first; nullopt
/// when it does not fit 32 bits.
std::optional<std::string> binary_text(double value, int decimals);

}  // namespace g31::fanuc

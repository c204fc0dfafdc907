#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

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
  enum class WithoutPopen : std::uint8_t { Alarm, Note, Prints };

  OutputStyle style;                                ///< of DPRNT with 6001.1 = 0
  WithoutPopen without_popen = WithoutPopen::Note;  ///< DPRNT and BPRNT
  int fewest_digits = 0;  ///< integer places and decimals of one variable, DPRNT
  int most_digits = 8;
  bool counts_sides_apart = false;  ///< most_digits of either side of the point
  int most_variables = 0;           ///< of one statement; 0: any
};

}  // namespace g31::fanuc

#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/text/output_format.h"
#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/functions.h"
#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"

// What values may stand where: the same for a run, which asks when it gets there, and for who looks
// at constants without running.

namespace g31::fanuc {

/// Why a value cannot stand where it is to stand: the alarm and what it says.
struct WrongValue {
  AlarmId id = AlarmId::ImproperCommand;
  std::string detail;
};

/// The variable number that a computed index means: rounded to the nearest integer (MB-099).
std::int32_t variable_number(double index);

/// Behind `/`.
/// @pre divisor.or_zero() == 0
WrongValue no_divisor(Cell divisor);

/// Whether AND, OR, XOR and MOD take a whole number: it fits 32 bits, with or without a sign.
constexpr bool fits_32_bits(double whole) {
  constexpr double kLimit = 2147483648.0;
  return whole >= -kLimit && whole < 2.0 * kLimit;
}
/// An operand of AND, OR, XOR or MOD as a whole number (MB-067 to MB-069, MB-363).
double whole_operand(OpCode op, double operand, LogicOperands rule);
/// nullopt: AND, OR, XOR or MOD of these has a value.  @param x, y  whole
std::optional<WrongValue> wrong_operands(OpCode op, double x, double y);

/// 16 -> 0x16: the BCD digits of an integer, and back; nullopt for what has none.
std::optional<double> to_bcd(double value);
std::optional<double> from_bcd(double value);

/// Whether a function has a value at an argument, as far as that depends on the argument alone.
bool is_defined_at(FunctionId id, double argument);
/// Of one that has none there.
WrongValue undefined_at(FunctionId id, double argument);

/// Whether a control with the functions of a level has an operation.
bool has_operation(const Op& op, FunctionLevel level);
/// Of one that the control has not.
WrongValue missing_operation(const Op& op);

/// nullopt: a program may read a variable.  @param row  nullptr: the control has no such variable
inline std::optional<AlarmId> why_unreadable(const SystemVariable* row) {
  return row == nullptr                 ? std::optional(AlarmId::IllegalVariable)
         : row->access == Access::Write ? std::optional(AlarmId::ReadProtected)
                                        : std::nullopt;
}
/// The same of writing.
inline std::optional<AlarmId> why_unwritable(const SystemVariable* row) {
  const bool is_protected =
      row != nullptr && (row->access == Access::Read || row->access == Access::Input);
  return row == nullptr ? std::optional(AlarmId::IllegalVariable)
         : is_protected ? std::optional(AlarmId::WriteProtected)
                        : std::nullopt;
}

/// Of a number that has more digits than the control takes.
WrongValue too_many_digits(std::uint8_t digits, int most);

/// No address of any control takes more (MB-032); it keeps positions and times finite, too.
inline constexpr double kLargestWord = 999'999'999.0;
inline constexpr int kDigitsOfLargestWord = 9;

/// Whether an address takes a number.
/// @param digits  as written; 0: computed
/// @param most    digits that the control takes
inline bool fits_address(double number, std::uint8_t digits, int most) {
  return digits <= most && std::abs(number) <= kLargestWord;
}
/// Of one that it does not take.
[[gnu::cold]] WrongValue wrong_word(char letter, double number, std::uint8_t digits, int most);

/// The format of an output statement.
std::optional<WrongValue> wrong_output(OutputStatement statement, const OutputRule& rule,
                                       const std::vector<OutputItem>& items);

/// L of a call.  @param times  a whole number
std::optional<WrongValue> wrong_repeats(int times);

}  // namespace g31::fanuc

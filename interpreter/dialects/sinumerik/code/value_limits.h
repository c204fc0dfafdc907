#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {

/// Why a value cannot stand where it is to stand: the alarm and what it says.
struct WrongValue {
  AlarmId id = AlarmId::BadConversion;
  std::string detail;
};

/// Whether a whole number is one of a type of whole numbers: INT has 32 bits, CHAR 8.
constexpr bool fits(Type type, double whole) {
  return type == Type::Char ? whole >= 0.0 && whole <= 255.0
                            : whole >= -2147483648.0 && whole <= 2147483647.0;
}

/// Of a number that does not fit.
/// @param alarm  of what was to become of it
WrongValue not_of_type(Type type, double value, AlarmId alarm);

/// Of a result that is no number.  @param b  the second operand
WrongValue no_number(double b);

/// Of a function that has no value at its first argument.
WrongValue undefined_at(FunctionId id, double argument);

/// BOUND(low, high, a)
std::optional<WrongValue> wrong_bounds(double low, double high);

/// P of a call or a repetition.
std::optional<WrongValue> wrong_passes(double passes);

/// LLI and ULI of a variable; nullopt: the value lies within.
std::optional<WrongValue> beyond_limits(const Variable& into, double value);

/// nullopt: the text has no more characters than STRING[longest].
std::optional<WrongValue> too_long(std::string_view text, std::int32_t longest);

/// An index that the array has not.
/// @param dimension  from 0
/// @param place      rounded
WrongValue no_such_index(const Variable& array, int dimension, double place, int size);

}  // namespace g31::sinumerik

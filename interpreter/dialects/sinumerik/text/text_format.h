#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/vocabulary/alarms.h"
#include "interpreter/dialects/sinumerik/vocabulary/value_type.h"
#include "machine/base/result.h"

namespace g31::sinumerik {

/// What << makes of a number: REAL in its shortest form, at most ten digits (12.5, -0.001), BOOL as
/// 0 or 1, CHAR as its character, AXIS as its name.
std::string shown(Type type, double number);

/// An INT, REAL, BOOL or AXIS as a program writes it, of its type and with all its digits: (-1.5).
std::string written_constant(Type type, double number);
/// The same of a text.
std::string written_constant(std::string_view text);

/// Arithmetic knows a negative zero; the control shows 0.
constexpr double without_sign_of_zero(double number) {
  return number + 0.0;
}

/// A text as it was written, each 'H41' or 'B01000001' in it made the character of that code, 0 to
/// 255; three quotes on end are no such constant.  A longer one is alarm 12220 or 12230.
Result<std::string, AlarmId> with_characters(std::string_view written);

/// The number that a text shows, blanks around it left out; nullopt: it shows none.
std::optional<double> number_in(std::string_view text);

/// A value for SPRINT.
struct SprintValue {
  Type type = Type::None;
  double number = 0.0;
  std::string text;
};

/// SPRINT: nullopt when the format asks for more values than there are, or for an unknown kind.
std::optional<std::string> sprint(std::string_view format, const std::vector<SprintValue>& values);

}  // namespace g31::sinumerik

#include "interpreter/dialects/sinumerik/code/value_limits.h"

#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/text/text_format.h"

namespace g31::sinumerik {

WrongValue not_of_type(Type type, double value, AlarmId alarm) {
  return {alarm, fmt::format("{} is not {}", shown(Type::Real, value), name_of(type))};
}

WrongValue no_number(double b) {
  return {AlarmId::ArithmeticError, b == 0.0 ? "division by zero" : "too large"};
}

WrongValue undefined_at(FunctionId id, double argument) {
  return {AlarmId::ArithmeticError,
          fmt::format("{} of {}", info(id).name, shown(Type::Real, argument))};
}

std::optional<WrongValue> wrong_bounds(double low, double high) {
  return low > high ? std::optional(WrongValue{AlarmId::BadArguments,
                                               "BOUND: the lower limit is above the upper one"})
                    : std::nullopt;
}

std::optional<WrongValue> wrong_passes(double passes) {
  constexpr double kMost = 9999.0;
  return passes < 0.0 || passes > kMost
             ? std::optional(WrongValue{AlarmId::BadRepeats, fmt::format("P{:.0f}", passes)})
             : std::nullopt;
}

std::optional<WrongValue> beyond_limits(const Variable& into, double value) {
  const bool below = into.limits.low && value < *into.limits.low;
  const bool above = into.limits.high && value > *into.limits.high;
  return below || above ? std::optional(WrongValue{
                              below ? AlarmId::BelowLimit : AlarmId::AboveLimit,
                              fmt::format("{} = {}", into.name, shown(Type::Real, value))})
                        : std::nullopt;
}

std::optional<WrongValue> too_long(std::string_view text, std::int32_t longest) {
  return text.size() > static_cast<std::size_t>(longest)
             ? std::optional(WrongValue{AlarmId::StringTooLong,
                                        fmt::format("\"{}\" in STRING[{}]", text, longest)})
             : std::nullopt;
}

WrongValue no_such_index(const Variable& array, int dimension, double place, int size) {
  constexpr std::array kAlarms = {AlarmId::IndexOne, AlarmId::IndexTwo, AlarmId::IndexThree};
  return {kAlarms.at(static_cast<std::size_t>(dimension)),
          fmt::format("{}[{}] of {}", array.name, shown(Type::Real, place), size)};
}

}  // namespace g31::sinumerik

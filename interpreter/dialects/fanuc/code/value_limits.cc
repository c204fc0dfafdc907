#include "interpreter/dialects/fanuc/code/value_limits.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/scanner.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "interpreter/runtime/angles.h"

namespace g31::fanuc {
namespace {

constexpr int kLargestRepeat = 9999;

}  // namespace

std::int32_t variable_number(double index) {
  constexpr double kParts = 1000.0;
  const bool has_part =
      may_have_part(index) && std::fmod(std::round(index * kParts), kParts) != 0.0;
  const double rounded = std::round(has_part ? index * kParts : index);
  // No control has variables beyond; a message names this one.
  constexpr double kLargest = 1e9;
  return static_cast<std::int32_t>(std::clamp(rounded, -kLargest, kLargest));
}

WrongValue no_divisor(Cell divisor) {
  return {AlarmId::DivisionByZero,
          divisor.is_vacant() ? "the divisor is vacant" : "the divisor is 0"};
}

double whole_operand(OpCode op, double operand, LogicOperands rule) {
  const bool truncates = rule == LogicOperands::Truncate && op != OpCode::Modulo;
  return truncates ? std::trunc(operand) : std::round(operand);
}

std::optional<WrongValue> wrong_operands(OpCode op, double x, double y) {
  if (!fits_32_bits(x) || !fits_32_bits(y)) {
    return WrongValue{AlarmId::IntegerOverflow, "an operand does not fit 32 bits"};
  }
  return op == OpCode::Modulo && y == 0.0
             ? std::optional(WrongValue{AlarmId::DivisionByZero, "the divisor of MOD is 0"})
             : std::nullopt;
}

std::optional<double> to_bcd(double value) {
  const double whole = std::round(value);
  if (whole < 0.0 || whole > 99'999'999.0) {
    return std::nullopt;
  }
  auto rest = static_cast<std::uint64_t>(whole);
  std::uint64_t digits = 0;
  for (int shift = 0; rest != 0; shift += 4, rest /= 10) {
    digits |= (rest % 10) << shift;
  }
  return static_cast<double>(digits);
}

std::optional<double> from_bcd(double value) {
  const double whole = std::round(value);
  if (whole < 0.0 || whole > 4294967295.0) {
    return std::nullopt;
  }
  std::uint64_t result = 0;
  std::uint64_t scale = 1;
  for (auto rest = static_cast<std::uint64_t>(whole); rest != 0; rest >>= 4, scale *= 10) {
    if ((rest & 15) > 9) {
      return std::nullopt;
    }
    result += (rest & 15) * scale;
  }
  return static_cast<double>(result);
}

bool is_defined_at(FunctionId id, double argument) {
  return id == FunctionId::SQRT                             ? argument >= 0.0
         : id == FunctionId::LN                             ? argument > 0.0
         : id == FunctionId::ASIN || id == FunctionId::ACOS ? std::abs(argument) <= 1.0
         : id == FunctionId::TAN                            ? runtime::cosine_deg(argument) != 0.0
         : id == FunctionId::BIN                            ? from_bcd(argument).has_value()
         : id == FunctionId::BCD                            ? to_bcd(argument).has_value()
                                                            : true;
}

WrongValue undefined_at(FunctionId id, double argument) {
  if (id == FunctionId::ASIN || id == FunctionId::ACOS) {
    return {AlarmId::ArcusArgument, fmt::format("the argument is {}", argument)};
  }
  const AlarmId alarm = id == FunctionId::TAN ? AlarmId::DivisionByZero : AlarmId::IllegalArgument;
  return {alarm, fmt::format("{} of {}", info(id).name, argument)};
}

bool has_operation(const Op& op, FunctionLevel level) {
  const bool is_function = op.code == OpCode::Call || op.code == OpCode::CallOfTwo;
  return is_function ? info(static_cast<FunctionId>(op.function)).level <= level
                     : level == FunctionLevel::Series30i ||
                           (op.code != OpCode::NumberOfName && op.code != OpCode::AxisParameter);
}

WrongValue missing_operation(const Op& op) {
  return op.code == OpCode::NumberOfName
             ? WrongValue{AlarmId::ExpressionFormat, "this control has no names of variables"}
         : op.code == OpCode::AxisParameter
             ? WrongValue{AlarmId::ImproperCommand, "this control has no PRM"}
             : WrongValue{AlarmId::ImproperCommand,
                          fmt::format("this control has no {}",
                                      info(static_cast<FunctionId>(op.function)).name)};
}

WrongValue too_many_digits(std::uint8_t digits, int most) {
  return {AlarmId::TooManyDigits,
          fmt::format("{}, the control takes {} here", digit_count(digits), most)};
}

WrongValue wrong_word(char letter, double number, std::uint8_t digits, int most) {
  return digits > most
             ? too_many_digits(digits, most)
             : WrongValue{AlarmId::TooManyDigits,
                          fmt::format("{} is {:g}, beyond every address", letter, number)};
}

std::optional<WrongValue> wrong_output(OutputStatement statement, const OutputRule& rule,
                                       const std::vector<OutputItem>& items) {
  auto why = statement == OutputStatement::DPRNT ? refused_by(rule, items) : std::nullopt;
  return why ? std::optional(WrongValue{AlarmId::OutputFormat, *std::move(why)}) : std::nullopt;
}

std::optional<WrongValue> wrong_repeats(int times) {
  return times < 0 || times > kLargestRepeat
             ? std::optional(WrongValue{AlarmId::IllegalAddress, "L repeats 0 to 9999 times"})
             : std::nullopt;
}

}  // namespace g31::fanuc

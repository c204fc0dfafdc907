#include "interpreter/dialects/fanuc/state/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/state/expression_reads.h"
#include "interpreter/runtime/angles.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kLargestParameter = 99'999.0;
constexpr double kSmallSine = 1e-8;  // 6004.1 MFZ

Cell truth(bool value) {
  return Cell(value ? 1.0 : 0.0);
}

/// Of an expression that nobody follows.
struct Unheard {
  void begins(const Op& /*op*/) {}
  void ends(const Op& /*op*/, Cell /*a*/, Cell /*b*/) {}
};

/// The functions that can have a second argument, for a switch over all of them.
enum class FunctionOfTwo : std::uint8_t {
#define One(name)
#define OneOrTwo(name) name = static_cast<std::uint8_t>(FunctionId::name),
#define Two(name) name = static_cast<std::uint8_t>(FunctionId::name),
#define Parameter(name) name = static_cast<std::uint8_t>(FunctionId::name),
#define FUNCTION(name, also, arguments, level, text) arguments(name)
#include "interpreter/dialects/fanuc/vocabulary/functions.def"
#undef FUNCTION
#undef Parameter
#undef Two
#undef OneOrTwo
#undef One
};

bool is_arithmetic(OpCode code) {
  return code == OpCode::Add || code == OpCode::Subtract || code == OpCode::Multiply ||
         code == OpCode::Divide;
}

/// Of numbers; none of them is a negative zero.
double arithmetic(OpCode code, double a, double b) {
  return code == OpCode::Add        ? a + b
         : code == OpCode::Subtract ? a - b
         : code == OpCode::Multiply ? a * b + 0.0
                                    : a / b + 0.0;
}

/// Of numbers.
bool compare(OpCode code, double a, double b) {
  if (code == OpCode::Equal || code == OpCode::NotEqual) {
    return (a == b) == (code == OpCode::Equal);
  }
  if (code == OpCode::Greater || code == OpCode::GreaterEqual) {
    return code == OpCode::Greater ? a > b : a >= b;
  }
  return code == OpCode::Less ? a < b : a <= b;
}

/// Vacant differs from 0 only for EQ and NE (MB-086, MB-087).
bool compare(OpCode code, Cell a, Cell b) {
  if (a.is_vacant() || b.is_vacant()) [[unlikely]] {
    return code == OpCode::Equal || code == OpCode::NotEqual
               ? equal(a, b) == (code == OpCode::Equal)
               : compare(code, a.or_zero(), b.or_zero());
  }
  return compare(code, a.raw(), b.raw());
}

}  // namespace

std::optional<EvaluationFault> Evaluator::take_fault() {
  std::optional<EvaluationFault> taken;
  taken.swap(fault_);
  return taken;
}

Cell Evaluator::fail(AlarmId id, std::string detail) {
  fault_ = EvaluationFault{id, {}, std::move(detail)};
  return {};
}

Cell Evaluator::fail(WrongValue wrong) {
  return fail(wrong.id, std::move(wrong.detail));
}

Cell Evaluator::read(std::int32_t number) {
  if (missed_.any()) {
    missed_.reads(holder_of(variables_.depth(), number));
  }
  const auto value = all_variables_.read(number);
  if (!value) {
    return fail(value.error(), fmt::format("#{} cannot be read", number));
  }
  return value.value();
}

Cell Evaluator::value(const CompiledProgram& program, syntax::Index code, double round_to) {
  if (!missed_.any()) [[likely]] {
    return evaluate(program, code, round_to);
  }
  ExpressionReads reads(missed_, variables_.depth());
  return evaluate_heard(program, code, round_to, reads);
}

bool Evaluator::condition(const CompiledProgram& program, syntax::Index code) {
  const bool holds = value(program, code).or_zero() != 0.0;
  if (missed_.any()) [[unlikely]] {
    missed_.decides();
  }
  return holds;
}

bool Evaluator::is_in_range(double result) const {
  const double size = std::abs(result);
  return size <= rules_.largest_result && (size >= rules_.smallest_result || size == 0.0);
}

Cell Evaluator::in_range(double result) {
  return is_in_range(result) ? Cell(result)
                             : fail(AlarmId::ResultOutOfRange,
                                    std::isfinite(result) ? fmt::format("the result is {}", result)
                                                          : "the result is beyond all numbers");
}

Cell Evaluator::evaluate(const CompiledProgram& program, syntax::Index code, double round_to) {
  Unheard nobody;
  return evaluate_heard(program, code, round_to, nobody);
}

// The hot loop of macro programs.
template <typename Listener>
Cell Evaluator::evaluate_heard(const CompiledProgram& program, syntax::Index code, double round_to,
                               Listener& listener) {
  const Cell* const banks[] = {program.constants.data(), variables_.locals(), variables_.commons(),
                               temporaries_.data()};
  for (const Op* op = &program.ops[code];; ++op) {
    listener.begins(*op);
    const Cell a = banks[static_cast<std::size_t>(op->a.bank)][op->a.place];
    if (op->code == OpCode::End) {
      return a;
    }
    const Cell b = banks[static_cast<std::size_t>(op->b.bank)][op->b.place];
    Cell& result = temporaries_[op->result];
    if (is_arithmetic(op->code)) {
      // A vacant operand is no number, and so is what comes of it: the result alone tells.
      result = Cell(arithmetic(op->code, a.raw(), b.raw()));
      if (!is_in_range(result.raw())) [[unlikely]] {
        result = arithmetic_of_vacant(op->code, a, b);
        if (fault_) {
          return at(program, *op);
        }
      }
    } else if (is_comparison(op->code)) {
      result = truth(compare(op->code, a, b));
    } else {
      result = rare_operation(program, *op, a, b, round_to);
      if (fault_) [[unlikely]] {
        return at(program, *op);
      }
    }
    listener.ends(*op, a, b);
  }
}

/// Arithmetic in which vacant counts as 0, and what has no result.
Cell Evaluator::arithmetic_of_vacant(OpCode code, Cell a, Cell b) {
  return code == OpCode::Divide && b.or_zero() == 0.0
             ? fail(no_divisor(b))
             : in_range(arithmetic(code, a.or_zero(), b.or_zero()));
}

/// Gives the fault its place.
Cell Evaluator::at(const CompiledProgram& program, const Op& op) {
  fault_->where = program.op_spans[static_cast<std::size_t>(&op - program.ops.data())];
  return {};
}

Cell Evaluator::rare_operation(const CompiledProgram& program, const Op& op, Cell a, Cell b,
                               double round_to) {
  if (op.is_missing) [[unlikely]] {
    return fail(missing_operation(op));
  }
  switch (op.code) {
    case OpCode::Negate:
      return a.is_vacant() ? Cell() : Cell(0.0 - a.raw());
    case OpCode::Read:
      return read(variable_number(a.or_zero()));
    case OpCode::Call:
      return function(op, a.or_zero(), round_to);
    case OpCode::CallOfTwo:
      return function_of_two(op, a.or_zero(), b.or_zero());
    case OpCode::NumberOfName:
      return number_of_name(program.names[static_cast<std::size_t>(b.or_zero())], a);
    case OpCode::AxisParameter:
      return axis_parameter(a.or_zero(), b.or_zero());
    case OpCode::LogicSwitch:
      return rules_.joins_conditions
                 ? Cell()
                 : fail(AlarmId::ExpressionFormat,
                        "AND, OR and XOR between comparisons need parameter 6006.0 = 1");
    case OpCode::DigitLimit:
      return op.function <= rules_.digit_limit
                 ? Cell()
                 : fail(too_many_digits(op.function, rules_.digit_limit));
    case OpCode::Modulo:
    case OpCode::And:
    case OpCode::Or:
    case OpCode::Xor:
      return integer_operation(op.code, a.or_zero(), b.or_zero());
    case OpCode::Add:
    case OpCode::Subtract:
    case OpCode::Multiply:
    case OpCode::Divide:
    case OpCode::Equal:
    case OpCode::NotEqual:
    case OpCode::Greater:
    case OpCode::Less:
    case OpCode::GreaterEqual:
    case OpCode::LessEqual:
    case OpCode::End:
      break;
  }
  contract_violated("evaluate() does the frequent operations itself", __FILE__, __LINE__);
}

/// The number of the variable that a name means (MB-104, MB-105).
Cell Evaluator::number_of_name(const std::string& name, Cell index) {
  const auto number = variables_.names.number(name, index);
  return number ? Cell(number.value()) : fail(number.error(), fmt::format("[#{}]", name));
}

/// PRM[number], PRM[number,bit] (MB-072).
Cell Evaluator::parameter(double number, std::optional<double> bit) {
  const double place = std::round(number);
  const double which = std::round(bit.value_or(0.0));
  if (place < 0.0 || place > kLargestParameter || which < 0.0 || which > 7.0) {
    return fail(AlarmId::IllegalArgument, fmt::format("PRM[{},{}]", number, bit.value_or(0.0)));
  }
  const int whole = static_cast<int>(place);
  return Cell(bit ? rules_.parameters->shown_bit(whole, static_cast<int>(which))
                  : rules_.parameters->shown(whole));
}

/// PRM[number]/[axis], axes counted from 1 (MB-072).
Cell Evaluator::axis_parameter(double number, double axis) {
  const double place = std::round(number);
  const auto which = controlled_axis(*rules_.axes, nearest_integer(axis) - 1);
  if (place < 0.0 || place > kLargestParameter || !which) {
    return fail(AlarmId::IllegalArgument, fmt::format("PRM[{}]/[{}]", number, axis));
  }
  return Cell(rules_.parameters->shown_for_axis(static_cast<int>(place), *which));
}

/// MOD AND OR XOR: both operands made 32-bit integers (MB-067 to MB-069, MB-363).
Cell Evaluator::integer_operation(OpCode op, double a, double b) {
  const double x = whole_operand(op, a, rules_.logic_operands);
  const double y = whole_operand(op, b, rules_.logic_operands);
  if (auto wrong = wrong_operands(op, x, y)) {
    return fail(std::move(*wrong));
  }
  if (op == OpCode::Modulo) {
    return Cell(std::fmod(x, y) + 0.0);
  }
  const auto left = static_cast<std::int32_t>(static_cast<std::int64_t>(x));
  const auto right = static_cast<std::int32_t>(static_cast<std::int64_t>(y));
  if (op == OpCode::And) {
    return Cell(static_cast<double>(left & right));
  }
  return Cell(static_cast<double>(op == OpCode::Or ? left | right : left ^ right));
}

Cell Evaluator::trigonometric(FunctionId id, double argument) {
  double result =
      id == FunctionId::COS ? runtime::cosine_deg(argument) : runtime::sine_deg(argument);
  if (id == FunctionId::TAN) {
    result /= runtime::cosine_deg(argument);
  }
  return Cell(rules_.clear_small_sines && std::abs(result) <= kSmallSine ? 0.0 : result);
}

Cell Evaluator::rounding_function(FunctionId id, double argument, double round_to) {
  if (id == FunctionId::ROUND) {
    // The guard absorbs the binary error of decimal fractions: 1.2345/0.001 counts as 1234.5.
    const double scaled = argument / round_to;
    const double guard = std::abs(scaled) * 4.0 * std::numeric_limits<double>::epsilon();
    return Cell(round_to == 1.0
                    ? std::round(argument) + 0.0
                    : std::round(scaled + std::copysign(guard, scaled)) * round_to + 0.0);
  }
  const double whole = std::trunc(argument);
  const bool is_whole = whole == argument;
  return Cell(id == FunctionId::FIX || is_whole ? whole + 0.0
                                                : whole + std::copysign(1.0, argument));
}

Cell Evaluator::function(const Op& op, double argument, double round_to) {
  const auto id = static_cast<FunctionId>(op.function);
  if (!is_defined_at(id, argument)) {
    return fail(undefined_at(id, argument));
  }
  switch (id) {
    case FunctionId::SIN:
    case FunctionId::COS:
    case FunctionId::TAN:
      return trigonometric(id, argument);
    case FunctionId::ASIN:
    case FunctionId::ACOS: {
      const double angle =
          (id == FunctionId::ASIN ? std::asin(argument) : std::acos(argument)) * kDegrees;
      return Cell(angle < 0.0 && !rules_.has_signed_arc_sine ? angle + 360.0 : angle);
    }
    case FunctionId::ATAN:
      return Cell(std::atan(argument) * kDegrees);
    case FunctionId::SQRT:
      return Cell(std::sqrt(argument));
    case FunctionId::ABS:
      return Cell(std::abs(argument));
    case FunctionId::ROUND:
    case FunctionId::FIX:
    case FunctionId::FUP:
      return rounding_function(id, argument, round_to);
    case FunctionId::LN:
      return Cell(std::log(argument));
    case FunctionId::EXP:
      return in_range(std::exp(argument));
    case FunctionId::BIN:
    case FunctionId::BCD:
      return Cell(*(id == FunctionId::BIN ? from_bcd(argument) : to_bcd(argument)));
    case FunctionId::ADP:
      return Cell(argument);
    case FunctionId::PRM:
      return parameter(argument, std::nullopt);
    case FunctionId::POW:
      break;
  }
  contract_violated("POW has two arguments", __FILE__, __LINE__);
}

Cell Evaluator::function_of_two(const Op& op, double a, double b) {
  switch (static_cast<FunctionOfTwo>(op.function)) {
    case FunctionOfTwo::PRM:
      return parameter(a, b);
    case FunctionOfTwo::POW: {
      const double power = std::pow(a, b);
      return power != power ? fail(AlarmId::IllegalArgument, fmt::format("POW[{},{}]", a, b))
                            : in_range(power);
    }
    case FunctionOfTwo::ATAN: {
      const double angle = std::atan2(a + 0.0, b + 0.0) * kDegrees;
      return Cell(angle < 0.0 && !rules_.signed_angles ? angle + 360.0 : angle);
    }
  }
  contract_violated("this function has one argument", __FILE__, __LINE__);
}

}  // namespace g31::fanuc

#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/runner.h"

namespace g31::sinumerik {
namespace {

constexpr double kLowestInt = -2147483648.0;
constexpr double kHighestInt = 2147483647.0;

std::int32_t bits(double number) {
  return static_cast<std::int32_t>(number);
}

bool is_int(double number) {
  return number >= kLowestInt && number <= kHighestInt;
}

}  // namespace

/// Keeps the reason; @returns false, for the way out.
bool Runner::failed(AlarmId id, std::string detail) {
  fault_ = failure(id, std::move(detail));
  return false;
}

/// Steps that cannot fail, the hot ones first.
Runner::Taken Runner::number_step(const Op& op) {
  if (op.code > OpCode::JumpIfNot) {
    return Taken::NotMine;
  }
  const double a = number(op.a);
  const auto b = [&] { return number(op.b); };
  double result = 0.0;
  switch (static_cast<int>(op.code)) {
    case static_cast<int>(OpCode::Move):
      result = a;
      break;
    case static_cast<int>(OpCode::Negate):
      result = -a;
      break;
    case static_cast<int>(OpCode::Not):
      result = a == 0.0 ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::Equal):
      result = a == b() ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::NotEqual):
      result = a != b() ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::Less):
      result = a < b() ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::Greater):
      result = a > b() ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::LessEqual):
      result = a <= b() ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::GreaterEqual):
      result = a >= b() ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::And):
      result = a != 0.0 && b() != 0.0 ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::Or):
      result = a != 0.0 || b() != 0.0 ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::Xor):
      result = (a != 0.0) != (b() != 0.0) ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::BitAnd):
      result = bits(a) & bits(b());
      break;
    case static_cast<int>(OpCode::BitOr):
      result = bits(a) | bits(b());
      break;
    case static_cast<int>(OpCode::BitXor):
      result = bits(a) ^ bits(b());
      break;
    case static_cast<int>(OpCode::BitNot):
      result = ~bits(a);
      break;
    case static_cast<int>(OpCode::ToBool):
      result = a != 0.0 ? 1.0 : 0.0;
      break;
    case static_cast<int>(OpCode::Jump):
      level().step = op.a.place;
      return Taken::Done;
    case static_cast<int>(OpCode::JumpIfNot):
      level().step = a == 0.0 ? op.b.place : level().step;
      return Taken::Done;
    default:
      return checked_step(op);
  }
  number(op.result) = result;
  return Taken::Done;
}

/// Steps whose result may be no number.
Runner::Taken Runner::checked_step(const Op& op) {
  const double a = number(op.a);
  const double b = number(op.b);
  double result = 0.0;
  switch (static_cast<int>(op.code)) {
    case static_cast<int>(OpCode::Add):
      result = a + b;
      break;
    case static_cast<int>(OpCode::Subtract):
      result = a - b;
      break;
    case static_cast<int>(OpCode::Multiply):
      result = a * b;
      break;
    case static_cast<int>(OpCode::Divide):
      result = a / b;
      break;
    case static_cast<int>(OpCode::DivideWhole):
      result = std::trunc(a / b);
      break;
    case static_cast<int>(OpCode::Modulo):
      result = std::fmod(a, b);
      break;
    case static_cast<int>(OpCode::Math): {
      const auto id = static_cast<FunctionId>(op.detail);
      const auto value = mathematics(id, a, b);
      if (!value) {
        failed(AlarmId::ArithmeticError,
               fmt::format("{} of {}", info(id).name, shown(Type::Real, a)));
        return Taken::Failed;
      }
      result = *value;
      break;
    }
    case static_cast<int>(OpCode::ToInt):
    case static_cast<int>(OpCode::CheckInt): {
      result = rounded(a);
      const bool converts = op.code == OpCode::ToInt;
      if (!is_int(result)) {
        failed(converts ? AlarmId::BadConversion : AlarmId::ArithmeticError,
               fmt::format("{} is no INT", shown(Type::Real, a)));
        return Taken::Failed;
      }
      break;
    }
    default:  // ToChar
      result = rounded(a);
      if (!(result >= 0.0 && result <= 255.0)) {
        failed(AlarmId::BadConversion, fmt::format("{} is no CHAR", shown(Type::Real, a)));
        return Taken::Failed;
      }
      break;
  }
  if (!std::isfinite(result)) [[unlikely]] {
    failed(AlarmId::ArithmeticError, b == 0.0 ? "division by zero" : "too large");
    return Taken::Failed;
  }
  number(op.result) = result;
  return Taken::Done;
}

Reference Runner::variable(std::int32_t which) {
  const Variable& known = level().program->variables[static_cast<std::size_t>(which)];
  if (known.storage == Storage::Reference) {
    return level().references[static_cast<std::size_t>(known.place)];
  }
  const bool is_global = known.storage == Storage::Global;
  Reference found;
  found.type = known.type;
  found.shape = known.shape;
  found.longest = known.longest;
  if (known.type == Type::String) {
    found.texts = (is_global ? channel_.texts : level().texts).data() + known.place;
  } else if (known.type == Type::Frame) {
    found.frames = (is_global ? channel_.frames : level().frames).data() + known.place;
  } else {
    found.numbers = (is_global ? channel_.numbers : level().numbers).data() + known.place;
  }
  return found;
}

/// result = result * size + a, when a is an index of that dimension.
bool Runner::index(const Op& op) {
  const Variable& known = level().program->variables[static_cast<std::size_t>(op.b.place)];
  const Shape shape =
      known.storage == Storage::Reference ? variable(op.b.place).shape : known.shape;
  const double at = rounded(number(op.a));
  const int size = shape.size[op.detail];
  if (!(at >= 0.0 && at < size)) {
    constexpr AlarmId kAlarms[] = {AlarmId::IndexOne, AlarmId::IndexTwo, AlarmId::InvalidIndex};
    return failed(kAlarms[op.detail],
                  fmt::format("{}[{}] of {}", known.name, shown(Type::Real, at), size));
  }
  double& result = number(op.result);
  result = result * size + at;
  return true;
}

Runner::Taken Runner::array_step(const Op& op) {
  const auto taken = [](bool done) { return done ? Taken::Done : Taken::Failed; };
  switch (static_cast<int>(op.code)) {
    case static_cast<int>(OpCode::Index):
      return taken(index(op));
    case static_cast<int>(OpCode::Load):
      number(op.result) = variable(op.b.place).numbers[static_cast<std::size_t>(number(op.a))];
      return Taken::Done;
    case static_cast<int>(OpCode::Store):
      variable(op.b.place).numbers[static_cast<std::size_t>(number(op.a))] = number(op.result);
      return Taken::Done;
    case static_cast<int>(OpCode::Fill):
      return taken(fill(op));
    case static_cast<int>(OpCode::Repeat):
      return taken(repeat_value(op));
    default:
      return Taken::NotMine;
  }
}

}  // namespace g31::sinumerik

#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/runner.h"

namespace g31::sinumerik {
namespace {

constexpr double kLowestInt = -2147483648.0;
constexpr double kHighestInt = 2147483647.0;

/// A code as switch takes it: not every switch is about all of them.
constexpr int at(OpCode code) {
  return static_cast<int>(code);
}

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

namespace {

/// Comparisons and logic: steps that cannot fail.  nullopt: another step.
std::optional<double> judged(OpCode code, double a, double b) {
  const auto truth = [](bool holds) { return holds ? 1.0 : 0.0; };
  switch (at(code)) {
    case at(OpCode::Equal):
      return truth(a == b);
    case at(OpCode::NotEqual):
      return truth(a != b);
    case at(OpCode::Less):
      return truth(a < b);
    case at(OpCode::Greater):
      return truth(a > b);
    case at(OpCode::LessEqual):
      return truth(a <= b);
    case at(OpCode::GreaterEqual):
      return truth(a >= b);
    case at(OpCode::And):
      return truth(a != 0.0 && b != 0.0);
    case at(OpCode::Or):
      return truth(a != 0.0 || b != 0.0);
    case at(OpCode::Xor):
      return truth((a != 0.0) != (b != 0.0));
    case at(OpCode::BitAnd):
      return bits(a) & bits(b);
    case at(OpCode::BitOr):
      return bits(a) | bits(b);
    case at(OpCode::BitXor):
      return bits(a) ^ bits(b);
    default:
      return std::nullopt;
  }
}

}  // namespace

/// Steps on numbers; the hot ones first.
Runner::Taken Runner::number_step(const Op& op) {
  if (op.code > OpCode::JumpIfNot) {
    return Taken::NotMine;
  }
  const double a = op.code == OpCode::Jump ? 0.0 : number(op.a);
  switch (at(op.code)) {
    case at(OpCode::Move):
      number(op.result) = a;
      return Taken::Done;
    case at(OpCode::Negate):
      number(op.result) = -a;
      return Taken::Done;
    case at(OpCode::Not):
      number(op.result) = a == 0.0 ? 1.0 : 0.0;
      return Taken::Done;
    case at(OpCode::BitNot):
      number(op.result) = ~bits(a);
      return Taken::Done;
    case at(OpCode::ToBool):
      number(op.result) = a != 0.0 ? 1.0 : 0.0;
      return Taken::Done;
    case at(OpCode::Jump):
      level().step = op.a.place;
      return Taken::Done;
    case at(OpCode::JumpIfNot):
      level().step = a == 0.0 ? op.b.place : level().step;
      return Taken::Done;
    default:
      break;
  }
  if (op.code >= OpCode::Equal && op.code <= OpCode::BitXor) {
    number(op.result) = *judged(op.code, a, number(op.b));
    return Taken::Done;
  }
  return checked_step(op);
}

/// Steps whose result may be no number.
Runner::Taken Runner::checked_step(const Op& op) {
  const double a = number(op.a);
  const double b = number(op.b);
  double result = 0.0;
  switch (at(op.code)) {
    case at(OpCode::Add):
      result = a + b;
      break;
    case at(OpCode::Subtract):
      result = a - b;
      break;
    case at(OpCode::Multiply):
      result = a * b;
      break;
    case at(OpCode::Divide):
      result = a / b;
      break;
    case at(OpCode::DivideWhole):
      result = std::trunc(a / b);
      break;
    case at(OpCode::Modulo):
      result = std::fmod(a, b);
      break;
    case at(OpCode::Math): {
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
    case at(OpCode::ToInt):
    case at(OpCode::CheckInt): {
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
  const double place = rounded(number(op.a));
  const int size = shape.size[op.detail];
  if (!(place >= 0.0 && place < size)) {
    constexpr AlarmId kAlarms[] = {AlarmId::IndexOne, AlarmId::IndexTwo, AlarmId::InvalidIndex};
    return failed(kAlarms[op.detail],
                  fmt::format("{}[{}] of {}", known.name, shown(Type::Real, place), size));
  }
  double& result = number(op.result);
  result = result * size + place;
  return true;
}

Runner::Taken Runner::array_step(const Op& op) {
  const auto taken = [](bool done) { return done ? Taken::Done : Taken::Failed; };
  switch (at(op.code)) {
    case at(OpCode::Index):
      return taken(index(op));
    case at(OpCode::Load):
      number(op.result) = variable(op.b.place).numbers[static_cast<std::size_t>(number(op.a))];
      return Taken::Done;
    case at(OpCode::Store):
      variable(op.b.place).numbers[static_cast<std::size_t>(number(op.a))] = number(op.result);
      return Taken::Done;
    case at(OpCode::Fill):
      return taken(fill(op));
    case at(OpCode::Repeat):
      return taken(repeat_value(op));
    default:
      return Taken::NotMine;
  }
}

}  // namespace g31::sinumerik

#include <string>
#include <utility>

#include "interpreter/dialects/sinumerik/code/operations.h"
#include "interpreter/dialects/sinumerik/vocabulary/operators.h"

namespace g31::sinumerik {

Expr Operations::constant(Type type, double value, ShortSpan where) {
  Expr result;
  result.type = type;
  result.value = code_.number_constant(value);
  result.where = where;
  result.is_constant = true;
  return result;
}

Expr Operations::inverted(const Token& token, Expr operand) {
  const bool negates = token.is(Symbol::Minus);
  const bool inverts = token.is_name("NOT");
  if (negates && operand.is_constant && is_number(operand.type)) {
    const double value = number_of(operand);
    return constant(operand.type, -value, joined(token.where, operand.where));
  }
  operand = inverts   ? boolean(std::move(operand))
            : negates ? std::move(operand)
                      : convert(std::move(operand), Type::Int);
  if (!failed() && !is_number(operand.type)) {
    fail(AlarmId::WrongType, operand.where, std::string(name_of(operand.type)));
  }
  Expr result;
  result.type = operand.type;
  result.where = joined(token.where, operand.where);
  result.value = temporary(result.type);
  const OpCode code = negates ? OpCode::Negate : inverts ? OpCode::Not : OpCode::BitNot;
  code_.emit(code, result.value, operand.value, {}, result.where);
  if (negates && result.type == Type::Int) {
    keep_to_32_bits(result);
  }
  return result;
}

void Operations::keep_to_32_bits(const Expr& whole) {
  code_.emit(OpCode::CheckInt, whole.value, whole.value, {}, whole.where);
}

Expr Operations::combine(int row, Expr left, Expr right) {
  const OperatorInfo& found = operators()[static_cast<std::size_t>(row)];
  const ShortSpan where = joined(left.where, right.where);
  if (failed()) {
    return {};
  }
  Type type = Type::None;
  switch (found.kind) {
    case OperatorKind::Comparison:
      return compare(found.code, std::move(left), std::move(right), where);
    case OperatorKind::Join:
      return concatenate(std::move(left), std::move(right), where);
    case OperatorKind::Arithmetic:
      return arithmetic(found.code, std::move(left), std::move(right), where);
    case OperatorKind::Logic:
      type = Type::Bool;
      left = boolean(std::move(left));
      right = boolean(std::move(right));
      break;
    case OperatorKind::Bits:
      type = Type::Int;
      left = convert(std::move(left), type);
      right = convert(std::move(right), type);
      break;
    case OperatorKind::Chain:
      type = Type::Frame;
      left = convert(std::move(left), type);
      right = convert(std::move(right), type);
      break;
  }
  Expr result;
  result.type = type;
  result.where = where;
  result.value = temporary(type);
  code_.emit(found.code, result.value, left.value, right.value, where);
  return result;
}

Expr Operations::compare(OpCode code, Expr left, Expr right, ShortSpan where) {
  Expr result;
  result.type = Type::Bool;
  result.where = where;
  result.value = temporary(Type::Bool);
  const bool is_text = left.type == Type::String || right.type == Type::String;
  const bool are_axes = left.type == Type::Axis && right.type == Type::Axis;
  if (is_text) {
    left = convert(std::move(left), Type::String);
    right = convert(std::move(right), Type::String);
    const bool swaps = code == OpCode::Greater || code == OpCode::LessEqual;
    const bool negates =
        code == OpCode::NotEqual || code == OpCode::LessEqual || code == OpCode::GreaterEqual;
    const bool equals = code == OpCode::Equal || code == OpCode::NotEqual;
    code_.emit(equals ? OpCode::EqualText : OpCode::LessText, result.value,
               swaps ? right.value : left.value, swaps ? left.value : right.value, where);
    if (negates) {
      code_.emit(OpCode::Not, result.value, result.value, {}, where);
    }
    return result;
  }
  const bool only_equals = code == OpCode::Equal || code == OpCode::NotEqual;
  if (left.type == Type::Frame && right.type == Type::Frame && only_equals) {
    code_.emit(OpCode::EqualFrame, result.value, left.value, right.value, where);
    if (code == OpCode::NotEqual) {
      code_.emit(OpCode::Not, result.value, result.value, {}, where);
    }
    return result;
  }
  const bool fits = (is_number(left.type) && is_number(right.type)) || (are_axes && only_equals);
  if (!fits) {
    fail(AlarmId::WrongType, where,
         std::string(name_of(left.type)) + " and " + std::string(name_of(right.type)));
  }
  code_.emit(code, result.value, left.value, right.value, where);
  return result;
}

Expr Operations::concatenate(Expr left, Expr right, ShortSpan where) {
  left = as_text(std::move(left));
  right = as_text(std::move(right));
  Expr result;
  result.type = Type::String;
  result.where = where;
  result.value = temporary(Type::String);
  code_.emit(OpCode::Concatenate, result.value, left.value, right.value, where);
  return result;
}

Expr Operations::as_text(Expr from) {
  expect_value(from);
  if (failed() || from.type == Type::String) {
    return from;
  }
  if (!is_held_as_number(from.type)) {
    fail(AlarmId::WrongType, from.where, std::string(name_of(from.type)));
    return from;
  }
  Expr result;
  result.type = Type::String;
  result.where = from.where;
  result.value = temporary(Type::String);
  code_.emit(OpCode::NumberToText, result.value, from.value, {}, from.where);
  code_.last().detail = detail_of(from.type);
  return result;
}

Expr Operations::arithmetic(OpCode code, Expr left, Expr right, ShortSpan where) {
  Expr result;
  result.where = where;
  if (!is_number(left.type) || !is_number(right.type)) {
    fail(AlarmId::WrongType, where,
         std::string(name_of(left.type)) + " and " + std::string(name_of(right.type)));
  } else {
    const bool whole = left.type != Type::Real && right.type != Type::Real;
    result.type =
        code == OpCode::DivideWhole || (whole && code != OpCode::Divide) ? Type::Int : Type::Real;
  }
  result.value = temporary(result.type);
  code_.emit(code, result.value, left.value, right.value, where);
  // Two INT can leave the 32 bits only by these four; what DIV makes of REAL may be larger.
  const bool may_overflow =
      code == OpCode::Add || code == OpCode::Subtract || code == OpCode::Multiply ||
      (code == OpCode::DivideWhole && left.type != Type::Real && right.type != Type::Real);
  if (result.type == Type::Int && may_overflow) {
    keep_to_32_bits(result);
  }
  return result;
}

/// A number in its new type: where that has fewer values, a step rounds and checks it.
void Operations::narrow(Expr& value, Type from) {
  const Type to = value.type;
  const bool narrows = to == Type::Bool || (to == Type::Char && from != Type::Bool) ||
                       (to == Type::Int && from == Type::Real);
  if (!narrows) {
    return;
  }
  const OpCode code = to == Type::Bool   ? OpCode::ToBool
                      : to == Type::Char ? OpCode::ToChar
                                         : OpCode::ToInt;
  const Operand given = value.value;
  value.value = temporary(to);
  code_.emit(code, value.value, given, {}, value.where);
  value.is_constant = false;
}

void Operations::expect_value(const Expr& expr) {
  if (!failed() && expr.is_whole_array) {
    fail(AlarmId::InvalidIndex, expr.where, "an array is not a value");
  }
}

Expr Operations::convert(Expr from, Type to, AlarmId mismatch) {
  expect_value(from);
  if (failed() || from.type == to) {
    from.is_constant = from.is_constant && from.type == to;
    return from;
  }
  Expr result = from;
  result.type = to;
  result.variable = -1;
  const bool to_number = is_number(to);
  if (is_number(from.type) && to_number) {
    narrow(result, from.type);
  } else if (from.type == Type::String && (to == Type::Bool || to == Type::Char)) {
    result.value = temporary(to);
    code_.emit(OpCode::TextToNumber, result.value, from.value, {}, from.where);
    code_.last().detail = detail_of(to);
    result.is_constant = false;
  } else if ((from.type == Type::Char || from.type == Type::Bool) && to == Type::String) {
    return as_text(std::move(from));
  } else {
    fail(mismatch, from.where,
         std::string(name_of(from.type)) + " is no " + std::string(name_of(to)));
    result.is_constant = false;  // callers look at the numbers of constants
  }
  return result;
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/compiler.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "interpreter/dialects/sinumerik/vocabulary/operators.h"
#include "interpreter/source/latin_1.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {
namespace {

constexpr int kSignLevel = 10;    // closer than any operator with two operands
constexpr int kJoinLevel = 2;     // closer than <<
constexpr int kDeepestNest = 64;  // of brackets and signs

constexpr std::string_view symbol_text(Symbol symbol) {
  switch (symbol) {
    case Symbol::Equal:
      return "==";
    case Symbol::NotEqual:
      return "<>";
    case Symbol::Less:
      return "<";
    case Symbol::Greater:
      return ">";
    case Symbol::LessEqual:
      return "<=";
    case Symbol::GreaterEqual:
      return ">=";
    case Symbol::Concat:
      return "<<";
    case Symbol::Plus:
      return "+";
    case Symbol::Minus:
      return "-";
    case Symbol::Times:
      return "*";
    case Symbol::Slash:
      return "/";
    case Symbol::Colon:
      return ":";
    case Symbol::None:
    case Symbol::LeftParen:
    case Symbol::RightParen:
    case Symbol::LeftBracket:
    case Symbol::RightBracket:
    case Symbol::Comma:
    case Symbol::Assign:
      return "";
  }
  return "";
}

/// The row of operators.def that a token is; -1: none.
int operator_row(const Token& token) {
  const std::string_view text = token.kind == TokenKind::Symbol ? symbol_text(token.symbol)
                                : token.kind == TokenKind::Name ? token.text
                                                                : std::string_view();
  if (text.empty()) {
    return -1;
  }
  const auto rows = operators();
  const auto found = std::ranges::find(rows, text, &OperatorInfo::name);
  return found != rows.end() ? static_cast<int>(found - rows.begin()) : -1;
}

/// 'H12345678F': a constant in digits of its own that has too many of them.
bool is_long_constant(std::string_view text) {
  if (text.size() < 4 || text.front() != '\'' || text.back() != '\'') {
    return false;
  }
  const char kind = upper(text[1]);
  const std::string_view digits = kind == 'H' ? "0123456789ABCDEFabcdef" : kind == 'B' ? "01" : "";
  return text.substr(2, text.size() - 3).find_first_not_of(digits) == std::string_view::npos;
}

}  // namespace

Expr Compiler::constant(Type type, double value, ShortSpan where) {
  Expr result;
  result.type = type;
  result.value = code_.number_constant(value);
  result.where = where;
  result.is_constant = true;
  return result;
}

Expr Compiler::expression(int level) {
  Expr left = unary();
  int row = operator_row(cursor_.peek());
  while (!failed() && row >= 0 && operators()[static_cast<std::size_t>(row)].level >= level) {
    cursor_.next();
    Expr right = expression(operators()[static_cast<std::size_t>(row)].level + 1);
    expect_value(left);
    expect_value(right);
    left = combine(row, std::move(left), std::move(right));
    row = operator_row(cursor_.peek());
  }
  return left;
}

Expr Compiler::unary() {
  const Token token = cursor_.peek();
  const bool negates = token.is(Symbol::Minus);
  const bool inverts = token.is_name("NOT");
  const bool flips = token.is_name("B_NOT");
  const bool shows = token.is(Symbol::Concat);  // <<R1 is a text
  if (!negates && !inverts && !flips && !shows && !token.is(Symbol::Plus)) {
    return primary();
  }
  cursor_.next();
  if (++depth_ > kDeepestNest) {
    fail(AlarmId::NestedTooDeep, token.where);
    --depth_;
    return {};
  }
  Expr operand = expression(shows ? kJoinLevel : kSignLevel);
  --depth_;
  expect_value(operand);
  if (failed() || token.is(Symbol::Plus)) {
    return operand;
  }
  return shows ? as_text(std::move(operand)) : inverted(token, std::move(operand));
}

/// - NOT B_NOT
Expr Compiler::inverted(const Token& token, Expr operand) {
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
  return result;
}

Expr Compiler::primary() {
  if (++depth_ > kDeepestNest) {
    fail(AlarmId::NestedTooDeep);
    --depth_;
    return {};
  }
  Expr result;
  const Token token = cursor_.peek();
  if (token.kind == TokenKind::Integer || token.kind == TokenKind::Real) {
    cursor_.next();
    const bool whole = token.kind == TokenKind::Integer;
    result = constant(whole ? Type::Int : Type::Real, token.number, token.where);
  } else if (token.kind == TokenKind::Text) {
    cursor_.next();
    result = text_literal(token);
  } else if (cursor_.accept(Symbol::LeftParen)) {
    result = expression();
    result.where = joined(token.where, cursor_.peek().where);
    expect(Symbol::RightParen);
    result.variable = -1;  // (R1) is a value, no variable any more
  } else if (token.kind == TokenKind::Name) {
    result = name_in_expression();
  } else if (token.kind == TokenKind::Letter) {
    result = letter_in_expression();
  } else {
    const std::string text = text_of(token.where);
    fail(is_long_constant(text) ? AlarmId::ConstantTooLarge : AlarmId::SyntaxInText, text);
  }
  --depth_;
  return result;
}

Expr Compiler::text_literal(const Token& token) {
  const auto text = with_characters(source::one_byte_each(token.text));
  if (!text) {
    fail(text.error(), token.where, text_of(token.where));
    return {};
  }
  Expr result;
  result.type = Type::String;
  result.value = code_.text_constant(text.value());
  result.is_constant = true;
  result.where = token.where;
  return result;
}

Expr Compiler::letter_in_expression() {
  const Token letter = cursor_.next();
  const bool numbered = cursor_.peek().kind == TokenKind::Integer;
  if (letter.is_letter('R') && (numbered || cursor_.peek().is(Symbol::LeftBracket))) {
    return variable_access(find_variable("R"), letter.where);
  }
  std::string name(letter.text);
  name += numbered ? cursor_.peek().text : "";
  const int axis = globals_.axis(name);
  if (axis < 0 && purpose_ == Purpose::Data) {
    cursor_.skip_if(numbered, 1);
    return axis_of_data(letter);
  }
  if (axis < 0) {
    fail(AlarmId::NotDefined, letter.where, letter.text);
  } else if (numbered) {
    cursor_.next();
  }
  return constant(Type::Axis, axis, letter.where);
}

/// A name in data that stands where an axis does: a spindle of the machine that wrote them.
Expr Compiler::axis_of_data(const Token& name) {
  note_unknown(name);
  return constant(Type::Axis, kSpindleAxis, name.where);
}

Expr Compiler::name_in_expression() {
  const Token name = cursor_.next();
  if (name.text == "TRUE" || name.text == "FALSE") {
    return constant(Type::Bool, name.text == "TRUE" ? 1.0 : 0.0, name.where);
  }
  if (const auto function = find_function(name.text)) {
    return call_function(*function, name.where);
  }
  if (const std::int32_t variable = find_variable(name.text); variable >= 0) {
    return variable_access(variable, name.where);
  }
  if (const auto system = find_system_variable(name.text)) {
    return system_access(*system, name.where);
  }
  if (const int axis = globals_.axis(name.text); axis >= 0) {
    return constant(Type::Axis, axis, name.where);
  }
  if (purpose_ == Purpose::Data && cursor_.peek().is(Symbol::Comma)) {
    return axis_of_data(name);
  }
  if (find_keyword(name.text) == &Compiler::refused_statement) {
    refused_statement();
  } else {
    fail(AlarmId::NotDefined, name.where, name.text);
  }
  return {};
}

Expr Compiler::combine(int row, Expr left, Expr right) {
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

Expr Compiler::compare(OpCode code, Expr left, Expr right, ShortSpan where) {
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

Expr Compiler::concatenate(Expr left, Expr right, ShortSpan where) {
  left = as_text(std::move(left));
  right = as_text(std::move(right));
  Expr result;
  result.type = Type::String;
  result.where = where;
  result.value = temporary(Type::String);
  code_.emit(OpCode::Concatenate, result.value, left.value, right.value, where);
  return result;
}

/// What << makes of an operand.
Expr Compiler::as_text(Expr from) {
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

Expr Compiler::arithmetic(OpCode code, Expr left, Expr right, ShortSpan where) {
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
  // Two INT can leave the 32 bits only by these three.
  const bool may_overflow =
      code == OpCode::Add || code == OpCode::Subtract || code == OpCode::Multiply;
  if (result.type == Type::Int && may_overflow) {
    code_.emit(OpCode::CheckInt, result.value, result.value, {}, where);
  }
  return result;
}

/// A number in its new type: where that has fewer values, a step rounds and checks it.
void Compiler::narrow(Expr& value, Type from) {
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

void Compiler::expect_value(const Expr& expr) {
  if (!failed() && expr.is_whole_array) {
    fail(AlarmId::InvalidIndex, expr.where, "an array is not a value");
  }
}

Expr Compiler::convert(Expr from, Type to, AlarmId mismatch) {
  expect_value(from);
  if (failed() || from.type == to) {
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
  }
  return result;
}

}  // namespace g31::sinumerik

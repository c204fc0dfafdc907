#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "interpreter/dialects/sinumerik/code/expressions.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "interpreter/dialects/sinumerik/vocabulary/constants.h"
#include "interpreter/dialects/sinumerik/vocabulary/operators.h"
#include "interpreter/source/latin_1.h"

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

Expr Expressions::expression(int level) {
  Expr left = unary();
  int row = operator_row(cursor_.peek());
  while (!failed() && row >= 0 && operators()[static_cast<std::size_t>(row)].level >= level) {
    cursor_.next();
    Expr right = expression(operators()[static_cast<std::size_t>(row)].level + 1);
    operations_.expect_value(left);
    operations_.expect_value(right);
    left = operations_.combine(row, std::move(left), std::move(right));
    row = operator_row(cursor_.peek());
  }
  return left;
}

Expr Expressions::unary() {
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
  operations_.expect_value(operand);
  if (failed() || token.is(Symbol::Plus)) {
    return operand;
  }
  return shows ? operations_.as_text(std::move(operand))
               : operations_.inverted(token, std::move(operand));
}

Expr Expressions::primary() {
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
    result = operations_.constant(whole ? Type::Int : Type::Real, token.number, token.where);
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

Expr Expressions::text_literal(const Token& token) {
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

Expr Expressions::letter_in_expression() {
  const Token letter = cursor_.next();
  const bool numbered = cursor_.peek().kind == TokenKind::Integer;
  if (letter.is_letter('R') && (numbered || cursor_.peek().is(Symbol::LeftBracket))) {
    return accesses_.variable_access(variables_.find("R"), letter.where);
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
  return operations_.constant(Type::Axis, axis, letter.where);
}

/// A name in data that stands where an axis does: a spindle of the machine that wrote them.
Expr Expressions::axis_of_data(const Token& name) {
  variables_.note_unknown(name);
  return operations_.constant(Type::Axis, kSpindleAxis, name.where);
}

Expr Expressions::name_in_expression() {
  const Token name = cursor_.next();
  if (const ConstantInfo* const constant = find_constant(name.text)) {
    return operations_.constant(constant->type, constant->value, name.where);
  }
  if (const auto function = find_function(name.text)) {
    return call_function(*function, name.where);
  }
  if (const std::int32_t variable = variables_.find(name.text); variable >= 0) {
    return accesses_.variable_access(variable, name.where);
  }
  if (const auto system = find_system_variable(name.text)) {
    return accesses_.system_access(*system, name.where);
  }
  if (const int axis = globals_.axis(name.text); axis >= 0) {
    return operations_.constant(Type::Axis, axis, name.where);
  }
  if (purpose_ == Purpose::Data && cursor_.peek().is(Symbol::Comma)) {
    return axis_of_data(name);
  }
  if (is_refused(name.text)) {
    reader_.refuse();
  } else {
    fail(AlarmId::NotDefined, name.where, name.text);
  }
  return {};
}

}  // namespace g31::sinumerik

#include <string>
#include <utility>

#include "interpreter/dialects/sinumerik/code/expressions.h"

namespace g31::sinumerik {

bool is_taken_by(char kind, const Argument& argument) {
  const bool is_element = argument.form == Argument::Form::Element;
  const bool is_whole = argument.form == Argument::Form::Whole;
  return kind == 'V'   ? is_element && is_number(argument.type)
         : kind == 'M' ? is_whole && argument.type == Type::Real
         : kind == 'W' ? (is_element || is_whole) && argument.type == Type::String
                       : true;
}

Expr Expressions::plain_mathematics(FunctionId id, ShortSpan where) {
  const std::size_t count = info(id).parameters.size();
  expect(Symbol::LeftParen);
  Expr a = operations_.convert(expression(), Type::Real, AlarmId::BadArguments);
  Expr b = a;
  if (count == 2) {
    if (cursor_.peek().is(Symbol::RightParen)) {
      fail(AlarmId::ArgumentCount, cursor_.peek().where, std::string(info(id).name));
    }
    expect(Symbol::Comma);
    b = operations_.convert(expression(), Type::Real, AlarmId::BadArguments);
  }
  Expr result;
  result.type = info(id).result;
  result.where = joined(where, cursor_.peek().where);
  if (cursor_.peek().is(Symbol::Comma)) {
    fail(AlarmId::ArgumentCount, cursor_.peek().where, std::string(info(id).name));
  }
  expect(Symbol::RightParen);
  result.value = temporary(result.type);
  code_.emit(OpCode::Math, result.value, a.value, b.value, result.where);
  code_.last().detail = detail_of(id);
  return result;
}

Expr Expressions::call_function(FunctionId id, ShortSpan where) {
  if (is_plain_mathematics(id)) {
    return plain_mathematics(id, where);
  }
  const FunctionInfo& row = info(id);
  expect(Symbol::LeftParen);
  std::vector<Argument> list;
  for (std::size_t i = 0; i < row.parameters.size() && !failed(); ++i) {
    const char kind = row.parameters[i];
    if (cursor_.peek().is(Symbol::RightParen)) {
      if (kind != '*' && kind >= 'A' && kind <= 'Z') {
        fail(AlarmId::ArgumentCount, cursor_.peek().where, std::string(row.name));
      }
      break;
    }
    if (!list.empty()) {
      expect(Symbol::Comma);
    }
    function_argument(kind, list);
    i -= kind == '*' ? 1 : 0;  // any more of them
    if (!failed() && !is_taken_by(kind, list.back())) {
      fail(AlarmId::ReferenceMissing, list.back().where, std::string(row.name));
    }
  }
  Expr result;
  result.type = row.result;
  result.where = joined(where, cursor_.peek().where);
  if (!cursor_.accept(Symbol::RightParen)) {
    fail(cursor_.peek().is(Symbol::Comma) ? AlarmId::ArgumentCount : AlarmId::SyntaxInText,
         cursor_.peek().where, std::string(row.name));
  }
  result.value = temporary(result.type);
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::Function, result.value, {},
             {Bank::Constants, static_cast<std::int32_t>(first)}, result.where);
  code_.last().detail = detail_of(id);
  code_.last().count = static_cast<std::uint16_t>(list.size());
  return result;
}

void Expressions::function_argument(char kind, std::vector<Argument>& list) {
  Expr value = expression();
  if (failed()) {
    return;
  }
  switch (kind) {
    case 'N':
    case 'n':
      value = operations_.convert(std::move(value), Type::Real, AlarmId::BadArguments);
      break;
    case 'S':
    case 's':
    case 'C':
      value = operations_.convert(std::move(value), Type::String, AlarmId::BadArguments);
      break;
    case 'A':
      value = operations_.convert(std::move(value), Type::Axis, AlarmId::NotAnAxis);
      break;
    case 'F':
      value = operations_.convert(std::move(value), Type::Frame, AlarmId::BadArguments);
      break;
    default:  // V keeps its variable, * any type
      break;
  }
  list.push_back(argument_of(value));
}

}  // namespace g31::sinumerik

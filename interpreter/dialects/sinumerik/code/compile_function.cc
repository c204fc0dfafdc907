#include <string>
#include <utility>

#include "interpreter/dialects/sinumerik/code/expressions.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

constexpr char kPairs = 'P';  // axes, each with its number

bool is_repeated(char kind) {
  return kind == '*' || kind == 'o' || kind == '#' || kind == kPairs;
}

/// With another argument behind it.
bool may_stand_empty(char kind) {
  return kind == 'o' || kind == 'm' || kind == 'i' || kind == 't';
}

/// Whether an argument is the variable that its parameter wants.
bool is_taken_by(char kind, const Argument& argument) {
  const bool is_element = argument.form == Argument::Form::Element;
  const bool is_whole = argument.form == Argument::Form::Whole;
  return kind == 'V'   ? is_element && is_number(argument.type)
         : kind == 'M' ? is_whole && argument.type == Type::Real
         : kind == 'W' ? (is_element || is_whole) && argument.type == Type::String
                       : true;
}

}  // namespace

bool may_be_missing(char kind) {
  return (kind >= 'a' && kind <= 'z') || kind == '*' || kind == '#' || kind == kPairs;
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
  const std::vector<Argument> list = arguments(row.parameters, row.name);
  Expr result;
  result.type = row.result;
  result.where = joined(where, cursor_.previous().where);
  result.value = temporary(result.type);
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::Function, result.value, {},
             {Bank::Constants, static_cast<std::int32_t>(first)}, result.where);
  code_.last().detail = detail_of(id);
  code_.last().count = static_cast<std::uint16_t>(list.size());
  return result;
}

std::vector<Argument> Expressions::arguments(std::string_view parameters, std::string_view name) {
  std::vector<Argument> list;
  for (std::size_t i = 0; i < parameters.size() && !failed();) {
    const char kind = parameters[i];
    if (cursor_.peek().is(Symbol::RightParen)) {
      if (!may_be_missing(kind)) {
        fail(AlarmId::ArgumentCount, cursor_.peek().where, std::string(name));
      }
      break;
    }
    if (!list.empty()) {
      expect(Symbol::Comma);
    }
    list.push_back(argument(kind == kPairs ? 'A' : kind));
    if (!failed() && !is_taken_by(kind, list.back())) {
      fail(AlarmId::ReferenceMissing, list.back().where, std::string(name));
    }
    if (kind == kPairs && !failed()) {
      if (cursor_.peek().is(Symbol::RightParen)) {
        fail(AlarmId::ArgumentCount, cursor_.peek().where, std::string(name));
        break;
      }
      expect(Symbol::Comma);
      list.push_back(argument('N'));
    }
    i += is_repeated(kind) ? 0U : 1U;
  }
  if (!failed() && !cursor_.accept(Symbol::RightParen)) {
    fail(cursor_.peek().is(Symbol::Comma) ? AlarmId::ArgumentCount : AlarmId::SyntaxInText,
         cursor_.peek().where, std::string(name));
  }
  return list;
}

/// An argument of a function or procedure.  @param kind  see functions.def
Argument Expressions::argument(char kind) {
  if (may_stand_empty(kind) &&
      (cursor_.peek().is(Symbol::Comma) || cursor_.peek().is(Symbol::RightParen))) {
    return {};
  }
  Expr value = expression();
  if (failed()) {
    return {};
  }
  switch (kind) {
    case 'N':
    case 'n':
    case 'm':
      value = operations_.convert(std::move(value), Type::Real, AlarmId::BadArguments);
      break;
    case 'C':
      if (is_number(value.type)) {
        value = operations_.convert(std::move(value), Type::Char, AlarmId::BadArguments);
      }
      value = operations_.convert(std::move(value), Type::String, AlarmId::BadArguments);
      break;
    case 'S':
    case 's':
      value = operations_.convert(std::move(value), Type::String, AlarmId::BadArguments);
      break;
    case 'A':
    case 'a':
      value = operations_.convert(std::move(value), Type::Axis, AlarmId::NotAnAxis);
      break;
    case 'F':
      value = operations_.convert(std::move(value), Type::Frame, AlarmId::BadArguments);
      break;
    case '#':
    case 'i':
      value = operations_.convert(std::move(value), Type::Int, AlarmId::BadArguments);
      break;
    case 't':
      if (value.type != Type::String) {
        value = operations_.convert(std::move(value), Type::Int, AlarmId::BadArguments);
      }
      break;
    case 'V':
    case 'M':
    case 'W':
    case '*':
    case 'o':
      break;  // a variable, or of any type
    default:
      contract_violated("every kind of parameter is read", __FILE__, __LINE__);
  }
  return argument_of(value);
}

}  // namespace g31::sinumerik

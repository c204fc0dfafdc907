// NAME[2] of a STRING, NAME[1,2] of an array of them: one character, counted from 0.

#include "interpreter/dialects/sinumerik/code/expressions.h"

namespace g31::sinumerik {

/// n] behind a string and a bracket: SUBSTR(string, n, 1) as a CHAR.
Expr Accesses::character_access(const Expr& string) {
  const Expr index = operations_.convert(expressions_.expression(), Type::Int, AlarmId::IndexType);
  expect(Symbol::RightBracket);
  if (failed()) {
    return {};
  }
  const Expr one = operations_.constant(Type::Int, 1.0, string.where);
  const std::vector<Argument> list = {argument_of(string), argument_of(index), argument_of(one)};
  Expr part;
  part.type = Type::String;
  part.where = string.where;
  part.value = temporary(Type::String);
  const std::uint32_t from = keep_arguments(list);
  code_.emit(OpCode::Function, part.value, {}, {Bank::Constants, static_cast<std::int32_t>(from)},
             string.where);
  code_.last().detail = detail_of(FunctionId::SUBSTR);
  code_.last().count = static_cast<std::uint16_t>(list.size());
  return operations_.convert(part, Type::Char);
}

}  // namespace g31::sinumerik

// NAME[2] of a STRING, NAME[1,2] of an array of them: one character, counted from 0.

#include "interpreter/dialects/sinumerik/code/compiler.h"

namespace g31::sinumerik {

/// SUBSTR(string, first, length)
Expr Compiler::part_of(const Expr& string, const Expr& first, const Expr* length) {
  std::vector<Argument> list = {argument_of(string), argument_of(first)};
  if (length != nullptr) {
    list.push_back(argument_of(*length));
  }
  Expr part;
  part.type = Type::String;
  part.where = string.where;
  part.value = temporary(Type::String);
  const std::uint32_t from = keep_arguments(list);
  code_.emit(OpCode::Function, part.value, {}, {Bank::Constants, static_cast<std::int32_t>(from)},
             string.where);
  code_.last().detail = detail_of(FunctionId::SUBSTR);
  code_.last().count = static_cast<std::uint16_t>(list.size());
  return part;
}

/// n] behind a string and a bracket.
Expr Compiler::character_access(const Expr& string) {
  const Expr index = convert(expression(), Type::Int, AlarmId::IndexType);
  expect(Symbol::RightBracket);
  if (failed()) {
    return {};
  }
  const Expr one = constant(Type::Int, 1.0, string.where);
  return convert(part_of(string, index, &one), Type::Char);
}

/// The text in front of the character, the new one, the text behind it.
void Compiler::assign_character(const Expr& target) {
  const Expr string = loaded(target);
  const Expr index = convert(expression(), Type::Int, AlarmId::IndexType);
  expect(Symbol::RightBracket);
  expect(Symbol::Assign);
  const Expr value = as_text(convert(expression(), Type::Char));
  if (failed()) {
    return;
  }
  const Expr begin = constant(Type::Int, 0.0, string.where);
  const Expr one = constant(Type::Int, 1.0, string.where);
  const Expr before = part_of(string, begin, &index);
  const Expr behind = part_of(string, arithmetic(OpCode::Add, index, one, string.where), nullptr);
  store(target, concatenate(concatenate(before, value, string.where), behind, string.where));
}

}  // namespace g31::sinumerik

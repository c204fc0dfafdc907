#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/code/assignments.h"

namespace g31::sinumerik {

void Assignments::assign_system(const SystemName& name, ShortSpan where) {
  std::vector<Argument> list = accesses_.system_indices(name, where);
  expect(Symbol::Assign);
  if (!failed() && name.row->access == Access::Read) {
    fail(AlarmId::WriteProtected, where, std::string(name.row->name));
  }
  const bool component = name.row->type == Type::Frame && list.size() >= 2;
  const Type type = component ? Type::Real : name.row->type;
  list.push_back(argument_of(operations_.convert(expressions_.expression(), type)));
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::WriteSystem, {}, {Bank::Constants, static_cast<std::int32_t>(name.row->id)},
             {Bank::Constants, static_cast<std::int32_t>(first)}, where);
  code_.last().detail = static_cast<std::uint8_t>(name.parameter);
  code_.last().count = static_cast<std::uint16_t>(list.size());
}

Expr Assignments::target_of(std::int32_t variable, ShortSpan where) const {
  const Variable& known = program_.variables[static_cast<std::size_t>(variable)];
  Expr target;
  target.type = known.type;
  target.where = where;
  target.variable = variable;
  target.value = {bank_of(known.storage), known.place};
  return target;
}

void Assignments::assign_variable(std::int32_t variable, ShortSpan where) {
  Expr target = target_of(variable, where);
  const Accesses::Element element = accesses_.element_or_part(variable);
  accesses_.place(target, element);
  if (element.is_open) {
    target.type == Type::Frame ? assign_component(target) : assign_character(target);
    return;
  }
  if (!cursor_.accept(Symbol::Assign)) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
    return;
  }
  assign_element(target);
}

void Assignments::assign_element(const Expr& target) {
  const Variable& known = program_.variables[static_cast<std::size_t>(target.variable)];
  const bool is_array = known.shape.dimensions > 0;
  if (is_array && cursor_.accept_name("REP")) {
    repeat_value(target);
  } else if (is_array && (cursor_.accept_name("SET") || looks_like_list())) {
    assign_list(target);
  } else {
    store(target, expressions_.expression());
  }
}

/// Whether a bracket opens a list: a comma stands in it, outside further brackets.
bool Assignments::looks_like_list() const {
  if (!cursor_.peek().is(Symbol::LeftParen)) {
    return false;
  }
  int depth = 0;
  for (std::size_t i = 0; cursor_.peek(i).kind != TokenKind::End; ++i) {
    const Token& token = cursor_.peek(i);
    depth += token.is(Symbol::LeftParen) || token.is(Symbol::LeftBracket) ? 1 : 0;
    depth -= token.is(Symbol::RightParen) || token.is(Symbol::RightBracket) ? 1 : 0;
    if (depth == 0) {
      return false;
    }
    if (depth == 1 && token.is(Symbol::Comma)) {
      return true;
    }
  }
  return false;
}

void Assignments::assign_list(const Expr& target) {
  expect(Symbol::LeftParen);
  std::vector<Argument> list;
  while (!failed()) {
    const bool omitted = cursor_.peek().is(Symbol::Comma) || cursor_.peek().is(Symbol::RightParen);
    list.emplace_back();
    if (!omitted) {
      list.back() = argument_of(
          operations_.convert(expressions_.expression(), target.type, AlarmId::InitialValueType));
      check_value(target, list.back().value, Reach::Array);
    }
    if (!cursor_.accept(Symbol::Comma)) {
      break;
    }
  }
  expect(Symbol::RightParen);
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::Fill, target.element, variable_number(target.variable),
             {Bank::Constants, static_cast<std::int32_t>(first)}, target.where);
  code_.last().count = static_cast<std::uint16_t>(list.size());
}

void Assignments::repeat_value(const Expr& target) {
  expect(Symbol::LeftParen);
  std::vector<Argument> list = {argument_of(
      operations_.convert(expressions_.expression(), target.type, AlarmId::InitialValueType))};
  check_value(target, list.front().value, Reach::Array);
  if (cursor_.accept(Symbol::Comma)) {
    list.push_back(argument_of(operations_.convert(expressions_.expression(), Type::Int)));
  }
  expect(Symbol::RightParen);
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::Repeat, target.element, variable_number(target.variable),
             {Bank::Constants, static_cast<std::int32_t>(first)}, target.where);
  code_.last().count = static_cast<std::uint16_t>(list.size());
}

/// A frame's component: the frame is read, changed and stored.
void Assignments::assign_component(const Expr& frame) {
  const Expr axis = accesses_.axis_operand();
  expect(Symbol::Comma);
  const Expr component = accesses_.component_operand();
  expect(Symbol::RightBracket);
  expect(Symbol::Assign);
  const Expr value = operations_.convert(expressions_.expression(), Type::Real);
  const Operand changed = temporary(Type::Frame);
  code_.emit(OpCode::LoadFrame, changed, frame.element, variable_number(frame.variable),
             frame.where);
  const std::uint32_t first =
      keep_arguments({argument_of(value), argument_of(axis), argument_of(component)});
  code_.emit(OpCode::StoreComponent, changed, {},
             {Bank::Constants, static_cast<std::int32_t>(first)}, frame.where);
  code_.last().count = 3;
  code_.emit(OpCode::StoreFrame, changed, frame.element, variable_number(frame.variable),
             frame.where);
}

void Assignments::assign_character(const Expr& target) {
  const Expr string = accesses_.loaded(target);
  const Expr index = operations_.convert(expressions_.expression(), Type::Int, AlarmId::IndexType);
  expect(Symbol::RightBracket);
  expect(Symbol::Assign);
  const Expr value = operations_.convert(expressions_.expression(), Type::Char);
  if (failed()) {
    return;
  }
  // Changed in a copy: whether the variable takes the text, store() says.
  const Variable& known = program_.variables[static_cast<std::size_t>(target.variable)];
  Expr changed = string;
  changed.value = temporary(Type::String);
  code_.emit(OpCode::MoveText, changed.value, string.value, {}, string.where);
  code_.emit(OpCode::SetCharacter, changed.value, index.value, value.value, string.where);
  code_.last().count = static_cast<std::uint16_t>(known.longest);
  store(target, changed);
}

void Assignments::check_value(const Expr& target, Operand value, Reach reach) {
  const Variable& known = program_.variables[static_cast<std::size_t>(target.variable)];
  if (!failed() && is_number(known.type) && (known.limits.low || known.limits.high)) {
    code_.emit(OpCode::CheckLimits, {}, value, variable_number(target.variable), target.where);
  }
  if (!failed() && (known.fixed || known.is_watched)) {
    code_.emit(OpCode::WatchDatum, target.element, value, variable_number(target.variable),
               target.where);
    code_.last().detail = reach == Reach::Array ? 1 : 0;
  }
}

void Assignments::store(const Expr& target, Expr value) {
  value = operations_.convert(std::move(value), target.type);
  if (failed()) {
    return;
  }
  check_value(target, value.value, Reach::Element);
  const Variable& known = program_.variables[static_cast<std::size_t>(target.variable)];
  const ShortSpan where{target.where.begin, std::max(target.where.end, value.where.end)};
  const bool is_plain = target.is_constant && is_held_as_number(target.type);
  if (!is_plain) {
    const OpCode code = known.type == Type::String  ? OpCode::StoreText
                        : known.type == Type::Frame ? OpCode::StoreFrame
                                                    : OpCode::Store;
    code_.emit(code, value.value, target.element, variable_number(target.variable), where);
    return;
  }
  // The step that made the value may as well leave it in the variable.
  Op& made = code_.last();
  const bool is_result = value.value.bank == Bank::Temporaries &&
                         made.result.bank == Bank::Temporaries &&
                         made.result.place == value.value.place && is_number_step(made.code);
  if (is_result) {
    made.result = target.value;
  } else {
    code_.emit(OpCode::Move, target.value, value.value, {}, where);
  }
}

void Assignments::pass_over(const Token& datum) {
  variables_.note_unknown(datum);
  const Token* before = &datum;
  while (cursor_.peek().kind != TokenKind::End &&
         (!cursor_.peek().text.starts_with('$') || before->is(Symbol::Assign))) {
    before = &cursor_.next();
  }
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/compiler.h"
#include "interpreter/dialects/sinumerik/vocabulary/frame_components.h"

namespace g31::sinumerik {
namespace {

Operand variable_number(std::int32_t variable) {
  return {Bank::Constants, variable};
}

/// Characters or components, which a further index names.
bool has_parts(const Variable& variable) {
  return variable.type == Type::String || variable.type == Type::Frame;
}

/// Whether a step may take or leave an element's number where it stands.
bool is_plain_memory(const Variable& variable) {
  return variable.storage != Storage::Reference && variable.unit == DatumUnit::Plain;
}

Bank bank_of(Storage storage) {
  return storage == Storage::Global ? Bank::Globals : Bank::Locals;
}

}  // namespace

/// -1: there is none of this name.
std::int32_t Compiler::find_variable(std::string_view name) {
  if (const auto local = program_->locals.find(name); local != program_->locals.end()) {
    return local->second;
  }
  const Variable* const global = globals_.find(name);
  return global != nullptr ? import(*global) : -1;
}

std::int32_t Compiler::import(const Variable& variable) {
  const auto [found, is_new] =
      imported_.emplace(variable.name, static_cast<std::int32_t>(program_->variables.size()));
  if (is_new) {
    program_->variables.push_back(variable);
  }
  return found->second;
}

/// Counts one more index in: at once where it is known, else by a step.
void Compiler::add_index(Element& element, std::int32_t variable, const Expr& index,
                         int dimension) {
  if (!failed() && !is_held_as_number(index.type)) {
    fail(AlarmId::IndexType, index.where, std::string(name_of(index.type)));
  }
  if (failed()) {
    return;
  }
  const Variable& known = program_->variables[static_cast<std::size_t>(variable)];
  const int size = known.shape.size[static_cast<std::size_t>(dimension)];
  const double value = index.is_constant ? number_of(index) : -1.0;
  const bool inside = value >= 0.0 && value < size && value == static_cast<std::int32_t>(value) &&
                      known.storage != Storage::Reference;
  if (element.is_fixed && inside) {
    element.offset = element.offset * size + static_cast<std::int32_t>(value);
    element.number = code_.number_constant(element.offset);
    return;
  }
  const Operand result = temporary(Type::Int);
  code_.emit(OpCode::Move, result, element.number, {}, index.where);
  code_.emit(OpCode::Index, result, index.value, variable_number(variable), index.where);
  code_.last().detail = static_cast<std::uint8_t>(dimension);
  element = {result, false, 0};
}

/// The element that [..] behind a variable names; number 0 where there are no brackets.
Compiler::Element Compiler::element_of(std::int32_t variable) {
  const Variable known = program_->variables[static_cast<std::size_t>(variable)];
  Element element{code_.number_constant(0.0), true, 0};
  if (known.name == "R" && cursor_.peek().kind == TokenKind::Integer) {
    const Token& number = cursor_.next();
    add_index(element, variable, constant(Type::Int, number.number, number.where), 0);
    return element;
  }
  const bool bracket = cursor_.accept(Symbol::LeftBracket);
  const int most = bracket ? std::max(1, known.shape.dimensions) : 0;
  int dimension = 0;
  while (!failed() && dimension < most && (dimension == 0 || cursor_.accept(Symbol::Comma))) {
    add_index(element, variable, expression(), dimension++);
  }
  element.is_open = bracket && has_parts(known) && cursor_.accept(Symbol::Comma);
  const bool too_many = bracket && cursor_.peek().is(Symbol::Comma);
  const bool fits = dimension == known.shape.dimensions && !too_many;
  if (!fits && !failed()) {
    fail(AlarmId::NoSuchElement, too_many ? cursor_.peek().where : block_, known.name);
  }
  if (bracket && !element.is_open) {
    expect(Symbol::RightBracket);
  }
  return element;
}

/// What stands behind the name of a variable: an element, or at once a part of the only one.
Compiler::Element Compiler::element_or_part(std::int32_t variable) {
  const Variable& known = program_->variables[static_cast<std::size_t>(variable)];
  if (known.shape.dimensions == 0 && has_parts(known) && cursor_.accept(Symbol::LeftBracket)) {
    return {code_.number_constant(0.0), true, 0, true};
  }
  return element_of(variable);
}

/// The value of an element: where it stands, or fetched from there.
Expr Compiler::loaded(const Expr& target) {
  if (target.is_constant) {
    return target;
  }
  Expr value = target;
  value.value = temporary(target.type);
  const OpCode code = target.type == Type::String  ? OpCode::LoadText
                      : target.type == Type::Frame ? OpCode::LoadFrame
                                                   : OpCode::Load;
  code_.emit(code, value.value, target.element, variable_number(target.variable), target.where);
  return value;
}

/// The value of a variable, of its element or component; a whole array where no index follows.
Expr Compiler::variable_access(std::int32_t variable, ShortSpan where) {
  const Variable known = program_->variables[static_cast<std::size_t>(variable)];
  Expr result;
  result.type = known.type;
  result.where = where;
  result.variable = variable;
  const bool indexed = cursor_.peek().is(Symbol::LeftBracket) ||
                       (known.name == "R" && cursor_.peek().kind == TokenKind::Integer);
  if (known.shape.dimensions > 0 && !indexed) {
    result.is_whole_array = true;
    return result;
  }
  const Element element = element_or_part(variable);
  place(result, element);
  result.where.end =
      cursor_.peek().where.begin > where.end ? where.end : cursor_.peek().where.begin;
  result = loaded(result);
  result.is_constant = false;
  if (element.is_open) {
    return known.type == Type::Frame ? component_access(result) : character_access(result);
  }
  return result;
}

/// X,TR] behind a frame and a bracket.
Expr Compiler::component_access(Expr frame) {
  const Expr axis = axis_operand();
  expect(Symbol::Comma);
  const Expr component = component_operand();
  expect(Symbol::RightBracket);
  Expr result;
  result.type = Type::Real;
  result.where = frame.where;
  result.value = temporary(Type::Real);
  const std::uint32_t first = keep_arguments({argument_of(axis), argument_of(component)});
  code_.emit(OpCode::LoadComponent, result.value, frame.value,
             {Bank::Constants, static_cast<std::int32_t>(first)}, frame.where);
  return result;
}

Expr Compiler::axis_operand() {
  Expr axis = expression();
  if (!failed() && axis.type != Type::Axis) {
    fail(AlarmId::NotAnAxis, axis.where, text_of(axis.where));
  }
  return axis;
}

Expr Compiler::component_operand() {
  const Token name = cursor_.next();
  const auto component = find_component(name.text);
  if (!component) {
    fail(AlarmId::InvalidIndex, name.where, text_of(name.where));
    return {};
  }
  return constant(Type::Int, static_cast<double>(*component), name.where);
}

/// The indices of a system variable; a frame may have axis and component behind them.
std::vector<Argument> Compiler::system_indices(const SystemName& name) {
  std::vector<Argument> list;
  std::string wanted(name.row->indices);
  bool is_optional = !wanted.empty() && wanted.front() == 'n';
  const bool is_frame = name.row->type == Type::Frame;
  if (!cursor_.peek().is(Symbol::LeftBracket)) {
    if (!wanted.empty() && !is_optional) {
      fail(AlarmId::InvalidIndex, cursor_.peek().where, std::string(name.row->name));
    }
    return list;
  }
  cursor_.next();
  for (std::size_t i = 0; i < wanted.size() && !failed(); ++i) {
    if (i > 0) {
      expect(Symbol::Comma);
    }
    list.push_back(argument_of(
        wanted[i] == 'A' ? axis_operand() : convert(expression(), Type::Int, AlarmId::IndexType)));
  }
  if (is_frame && !failed() && (wanted.empty() || cursor_.accept(Symbol::Comma))) {
    list.push_back(argument_of(axis_operand()));
    expect(Symbol::Comma);
    list.push_back(argument_of(component_operand()));
  }
  expect(Symbol::RightBracket);
  return list;
}

Expr Compiler::system_access(const SystemName& name, ShortSpan where) {
  const std::vector<Argument> list = system_indices(name);
  Expr result;
  const bool component = name.row->type == Type::Frame && list.size() >= 2;
  result.type = component ? Type::Real : name.row->type;
  result.where = where;
  result.value = temporary(result.type);
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::ReadSystem, result.value,
             {Bank::Constants, static_cast<std::int32_t>(name.row->id)},
             {Bank::Constants, static_cast<std::int32_t>(first)}, where);
  code_.last().detail = static_cast<std::uint8_t>(name.parameter);
  code_.last().count = static_cast<std::uint16_t>(list.size());
  return result;
}

std::uint32_t Compiler::keep_arguments(const std::vector<Argument>& list) {
  const auto first = static_cast<std::uint32_t>(program_->arguments.size());
  program_->arguments.insert(program_->arguments.end(), list.begin(), list.end());
  return first;
}

Argument Compiler::argument_of(const Expr& expr) {
  Argument argument;
  argument.form = expr.is_whole_array  ? Argument::Form::Whole
                  : expr.variable >= 0 ? Argument::Form::Element
                                       : Argument::Form::Value;
  argument.type = expr.type;
  argument.value = expr.value;
  argument.variable = expr.variable;
  argument.element = expr.element;
  argument.where = expr.where;
  return argument;
}

void Compiler::assign_system(const SystemName& name, ShortSpan where) {
  std::vector<Argument> list = system_indices(name);
  expect(Symbol::Assign);
  if (!failed() && name.row->access == Access::Read) {
    fail(AlarmId::WriteProtected, where, std::string(name.row->name));
  }
  const bool component = name.row->type == Type::Frame && list.size() >= 2;
  const Type type = component ? Type::Real : name.row->type;
  list.push_back(argument_of(convert(expression(), type)));
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::WriteSystem, {}, {Bank::Constants, static_cast<std::int32_t>(name.row->id)},
             {Bank::Constants, static_cast<std::int32_t>(first)}, where);
  code_.last().detail = static_cast<std::uint8_t>(name.parameter);
  code_.last().count = static_cast<std::uint16_t>(list.size());
}

/// A variable that takes a value: as a whole, until an element is named.
Expr Compiler::target_of(std::int32_t variable, ShortSpan where) const {
  const Variable& known = program_->variables[static_cast<std::size_t>(variable)];
  Expr target;
  target.type = known.type;
  target.where = where;
  target.variable = variable;
  target.value = {bank_of(known.storage), known.place};
  return target;
}

void Compiler::assign_variable(std::int32_t variable, ShortSpan where) {
  Expr target = target_of(variable, where);
  const Element element = element_or_part(variable);
  place(target, element);
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

/// Makes a variable the element of it that an index list says.
void Compiler::place(Expr& target, const Element& element) const {
  const Variable& known = program_->variables[static_cast<std::size_t>(target.variable)];
  target.element = element.number;
  target.is_constant = element.is_fixed && is_plain_memory(known);
  target.value = {bank_of(known.storage), known.place + element.offset};
}

/// What stands behind `=`: a value, or a list for an array from this element on.
void Compiler::assign_element(const Expr& target) {
  const Variable& known = program_->variables[static_cast<std::size_t>(target.variable)];
  const bool is_array = known.shape.dimensions > 0;
  if (is_array && cursor_.accept_name("REP")) {
    repeat_value(target);
  } else if (is_array && (cursor_.accept_name("SET") || looks_like_list())) {
    assign_list(target);
  } else {
    store(target, expression());
  }
}

/// Whether a bracket opens a list: a comma stands in it, outside further brackets.
bool Compiler::looks_like_list() const {
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

void Compiler::assign_list(const Expr& target) {
  expect(Symbol::LeftParen);
  std::vector<Argument> list;
  while (!failed()) {
    const bool omitted = cursor_.peek().is(Symbol::Comma) || cursor_.peek().is(Symbol::RightParen);
    list.emplace_back();
    if (!omitted) {
      list.back() = argument_of(convert(expression(), target.type, AlarmId::InitialValueType));
      check_limits(target, list.back().value);
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

void Compiler::repeat_value(const Expr& target) {
  expect(Symbol::LeftParen);
  std::vector<Argument> list = {
      argument_of(convert(expression(), target.type, AlarmId::InitialValueType))};
  check_limits(target, list.front().value);
  if (cursor_.accept(Symbol::Comma)) {
    list.push_back(argument_of(convert(expression(), Type::Int)));
  }
  expect(Symbol::RightParen);
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::Repeat, target.element, variable_number(target.variable),
             {Bank::Constants, static_cast<std::int32_t>(first)}, target.where);
  code_.last().count = static_cast<std::uint16_t>(list.size());
}

/// A frame's component: the frame is read, changed and stored.
void Compiler::assign_component(const Expr& frame) {
  const Expr axis = axis_operand();
  expect(Symbol::Comma);
  const Expr component = component_operand();
  expect(Symbol::RightBracket);
  expect(Symbol::Assign);
  const Expr value = convert(expression(), Type::Real);
  const Operand changed = temporary(Type::Frame);
  code_.emit(OpCode::LoadFrame, changed, frame.element, variable_number(frame.variable),
             frame.where);
  const std::uint32_t first =
      keep_arguments({argument_of(value), argument_of(axis), argument_of(component)});
  code_.emit(OpCode::StoreComponent, changed, {},
             {Bank::Constants, static_cast<std::int32_t>(first)}, frame.where);
  code_.emit(OpCode::StoreFrame, changed, frame.element, variable_number(frame.variable),
             frame.where);
}

void Compiler::check_limits(const Expr& target, Operand value) {
  const Variable& known = program_->variables[static_cast<std::size_t>(target.variable)];
  if (!failed() && is_number(known.type) && (known.limits.low || known.limits.high)) {
    code_.emit(OpCode::CheckLimits, {}, value, variable_number(target.variable), target.where);
  }
}

/// target = value, converted.
void Compiler::store(const Expr& target, Expr value) {
  value = convert(std::move(value), target.type);
  if (failed()) {
    return;
  }
  check_limits(target, value.value);
  const Variable& known = program_->variables[static_cast<std::size_t>(target.variable)];
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

/// A name in data that this control does not know; each once.
void Compiler::note_unknown(const Token& name) {
  auto& known = program_->unknown_data;
  const auto same = [&](const UnknownDatum& row) { return row.name == name.text; };
  if (std::ranges::none_of(known, same)) {
    known.push_back({std::string(name.text), name.where});
  }
}

/// Goes on at the next assignment to system data in the block, or at its end.
void Compiler::pass_over(const Token& datum) {
  note_unknown(datum);
  const Token* before = &datum;
  while (cursor_.peek().kind != TokenKind::End &&
         (!cursor_.peek().text.starts_with('$') || before->is(Symbol::Assign))) {
    before = &cursor_.next();
  }
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <string>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/expressions.h"
#include "interpreter/dialects/sinumerik/vocabulary/frame_components.h"

namespace g31::sinumerik {
namespace {

/// Characters or components, which a further index names.
bool has_parts(const Variable& variable) {
  return variable.type == Type::String || variable.type == Type::Frame;
}

/// Whether a step may take or leave an element's number where it stands.
bool is_plain_memory(const Variable& variable) {
  const bool is_elsewhere =
      variable.storage == Storage::Reference || variable.storage == Storage::OfMain;
  return !is_elsewhere && variable.unit == DatumUnit::Plain;
}

}  // namespace

/// Counts one more index in: at once where it is known, else by a step.
void Accesses::add_index(Element& element, std::int32_t variable, const Expr& index,
                         int dimension) {
  if (!failed() && !is_held_as_number(index.type)) {
    fail(AlarmId::IndexType, index.where, std::string(name_of(index.type)));
  }
  if (failed()) {
    return;
  }
  const Variable& known = program_.variables[static_cast<std::size_t>(variable)];
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
Accesses::Element Accesses::element_of(std::int32_t variable) {
  const Variable known = program_.variables[static_cast<std::size_t>(variable)];
  Element element{code_.number_constant(0.0), true, 0};
  if (known.name == "R" && cursor_.peek().kind == TokenKind::Integer) {
    const Token& number = cursor_.next();
    add_index(element, variable, operations_.constant(Type::Int, number.number, number.where), 0);
    return element;
  }
  const bool bracket = cursor_.accept(Symbol::LeftBracket);
  const int most = bracket ? std::max(1, known.shape.dimensions) : 0;
  int dimension = 0;
  while (!failed() && dimension < most && (dimension == 0 || cursor_.accept(Symbol::Comma))) {
    add_index(element, variable, expressions_.expression(), dimension++);
  }
  element.is_open = bracket && has_parts(known) && cursor_.accept(Symbol::Comma);
  const bool too_many = bracket && cursor_.peek().is(Symbol::Comma);
  const bool fits = dimension == known.shape.dimensions && !too_many;
  if (!fits && !failed()) {
    fail(AlarmId::NoSuchElement, too_many ? cursor_.peek().where : block(), known.name);
  }
  if (bracket && !element.is_open) {
    expect(Symbol::RightBracket);
  }
  return element;
}

Accesses::Element Accesses::element_or_part(std::int32_t variable) {
  const Variable& known = program_.variables[static_cast<std::size_t>(variable)];
  if (known.shape.dimensions == 0 && has_parts(known) && cursor_.accept(Symbol::LeftBracket)) {
    return {code_.number_constant(0.0), true, 0, true};
  }
  return element_of(variable);
}

Expr Accesses::loaded(const Expr& target) {
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

Expr Accesses::variable_access(std::int32_t variable, ShortSpan where) {
  const Variable known = program_.variables[static_cast<std::size_t>(variable)];
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
Expr Accesses::component_access(Expr frame) {
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

Expr Accesses::axis_operand() {
  Expr axis = expressions_.expression();
  if (!failed() && axis.type != Type::Axis) {
    fail(AlarmId::NotAnAxis, axis.where, text_of(axis.where));
  }
  return axis;
}

Expr Accesses::component_operand() {
  const Token name = cursor_.next();
  const auto component = find_component(name.text);
  if (!component) {
    fail(AlarmId::InvalidIndex, name.where, text_of(name.where));
    return {};
  }
  return operations_.constant(Type::Int, static_cast<double>(*component), name.where);
}

std::vector<Argument> Accesses::system_indices(const SystemName& name, ShortSpan where) {
  if (name.row->access == Access::Refused) {
    fail(AlarmId::NotImplemented, where,
         std::string(name.row->name) + ", " + std::string(name.row->text));
  }
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
        wanted[i] == 'A'
            ? axis_operand()
            : operations_.convert(expressions_.expression(), Type::Int, AlarmId::IndexType)));
  }
  if (is_frame && !failed() && (wanted.empty() || cursor_.accept(Symbol::Comma))) {
    list.push_back(argument_of(axis_operand()));
    expect(Symbol::Comma);
    list.push_back(argument_of(component_operand()));
  }
  expect(Symbol::RightBracket);
  return list;
}

Expr Accesses::system_access(const SystemName& name, ShortSpan where) {
  const std::vector<Argument> list = system_indices(name, where);
  program_.reads_block_time = program_.reads_block_time || name.row->id == SystemId::BlockTime;
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

void Accesses::place(Expr& target, const Element& element) const {
  const Variable& known = program_.variables[static_cast<std::size_t>(target.variable)];
  target.element = element.number;
  target.is_constant = element.is_fixed && is_plain_memory(known);
  target.value = {bank_of(known.storage), known.place + element.offset};
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/sinumerik/code/wrong_argument.h"

#include <fmt/format.h>

namespace g31::sinumerik {
namespace {

using Form = Argument::Form;

bool becomes(Type given, Type wanted) {
  return given == wanted || (is_number(given) && is_number(wanted)) ||
         ((given == Type::Char || given == Type::Bool) && wanted == Type::String) ||
         (given == Type::String && wanted == Type::Char);
}

std::optional<WrongArgument> wrong_reference(const Variable& variable, const GivenArgument& given) {
  if (given.form == Form::Omitted) {
    return WrongArgument{AlarmId::ReferenceMissing, variable.name};
  }
  if (given.form == Form::Value) {
    return WrongArgument{AlarmId::NotAReference, variable.name};
  }
  if (given.type != variable.type) {
    return wrong_type(variable, given.type);
  }
  if (given.dimensions != variable.shape.dimensions) {
    return WrongArgument{AlarmId::WrongDimension, variable.name};
  }
  return std::nullopt;
}

}  // namespace

WrongArgument wrong_type(const Variable& variable, Type given) {
  return {AlarmId::WrongArgumentType,
          fmt::format("{}: {} is not {}", variable.name, name_of(given), name_of(variable.type))};
}

GivenArgument given_by(const Argument& argument, const CompiledProgram& caller) {
  const bool is_whole = argument.form == Form::Whole;
  return {argument.form, argument.type,
          is_whole ? caller.variables[static_cast<std::size_t>(argument.variable)].shape.dimensions
                   : 0};
}

std::optional<WrongArgument> wrong_argument(const Parameter& parameter, const Variable& variable,
                                            const GivenArgument& given) {
  if (parameter.by_reference) {
    return wrong_reference(variable, given);
  }
  if (given.form == Form::Omitted) {
    const bool needs_axis = variable.type == Type::Axis && !parameter.has_preset;
    return needs_axis ? std::optional(WrongArgument{AlarmId::AxisMissing, variable.name})
                      : std::nullopt;
  }
  if (given.form == Form::Whole || !becomes(given.type, variable.type)) {
    return wrong_type(variable, given.type);
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik

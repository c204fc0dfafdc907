#include "interpreter/dialects/sinumerik/state/call_arguments.h"

#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/value_limits.h"
#include "interpreter/dialects/sinumerik/code/wrong_argument.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {
namespace {

using Form = Argument::Form;

/// A number as a parameter of another type takes it.
Result<double, Failure> converted(double value, const Variable& to) {
  const auto kept = kept_as(to.type, value);
  return kept
             ? Result<double, Failure>(*kept)
             : failure(AlarmId::BadConversion, fmt::format("{}: no {}", to.name, name_of(to.type)));
}

/// A value whose type fits.
MaybeFailure take_value(Level& into, const Variable& variable, const BoundValue& value) {
  const auto place = static_cast<std::size_t>(variable.place);
  if (variable.type == Type::String) {
    const std::string given =
        value.type == Type::String ? value.text : shown(value.type, value.number);
    if (const auto wrong = too_long(given, variable.longest)) {
      return failure(wrong->id, fmt::format("{}: {}", variable.name, wrong->detail));
    }
    into.texts[place] = given;
  } else if (variable.type == Type::Frame) {
    into.frames[place] = *value.frame;
  } else {
    const bool is_text = value.type == Type::String;
    if (is_text && value.text.size() != 1) {
      WrongArgument wrong = wrong_type(variable, value.type);
      return failure(wrong.id, std::move(wrong.detail));
    }
    const auto number = converted(
        is_text ? static_cast<unsigned char>(value.text.front()) : value.number, variable);
    if (!number) {
      return number.error();
    }
    into.numbers[place] = number.value();
  }
  return std::nullopt;
}

MaybeFailure take_argument(Level& into, const Parameter& parameter, const BoundValue& value) {
  const Variable& variable = into.program->variables[static_cast<std::size_t>(parameter.variable)];
  const GivenArgument given = {value.form, value.type, value.reference.shape.dimensions};
  if (auto wrong = wrong_argument(parameter, variable, given)) {
    return failure(wrong->id, std::move(wrong->detail));
  }
  if (parameter.by_reference) {
    into.references.push_back(value.reference);
    return std::nullopt;
  }
  if (value.form != Form::Omitted) {
    return take_value(into, variable, value);
  }
  if (parameter.has_preset && variable.type == Type::String) {
    into.texts[static_cast<std::size_t>(variable.place)] = parameter.text;
  } else if (parameter.has_preset) {
    into.numbers[static_cast<std::size_t>(variable.place)] = parameter.number;
  }
  return std::nullopt;
}

}  // namespace

MaybeFailure take_arguments(Level& into, const std::vector<BoundValue>& values) {
  const CompiledProgram& program = *into.program;
  into.make_locals();
  into.references.clear();
  into.given.assign(program.parameters.size(), false);
  if (program.has_wrong_proc) {
    return std::nullopt;
  }
  if (values.size() > program.parameters.size()) {
    return failure(AlarmId::TooManyArguments, program.name);
  }
  static const BoundValue kOmitted;
  for (std::size_t i = 0; i < program.parameters.size(); ++i) {
    const BoundValue& value = i < values.size() ? values[i] : kOmitted;
    into.given[i] = value.form != Form::Omitted;
    if (MaybeFailure wrong = take_argument(into, program.parameters[i], value)) {
      return wrong;
    }
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik

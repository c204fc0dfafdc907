#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/called_programs.h"
#include "interpreter/dialects/sinumerik/run/functions.h"
#include "interpreter/dialects/sinumerik/run/named_variable.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "machine/base/contract.h"
#include "machine/base/letters.h"
#include "machine/units/within_turn.h"

namespace g31::sinumerik {
namespace {

/// A place in a text, from 0; -1: nowhere.
MaybeFailure take_place(Operands& at, const Op& op, std::size_t place) {
  at.number(op.result) = place == std::string::npos ? -1.0 : static_cast<double>(place);
  return std::nullopt;
}

MaybeFailure needs_one_character(Operands& at, const Op& op, Arguments list) {
  return at.text(list[1].value).size() == 1
             ? std::nullopt
             : MaybeFailure(
                   failure(AlarmId::BadArguments, function::name_of(op) + ": one character"));
}

}  // namespace

MaybeFailure FunctionCaller::call(const Op& op) {
  switch (static_cast<FunctionId>(op.detail)) {
#define OfOne(f) break
#define OfTwo(f) break
#define Called(f) return call(function::f, op)
#define FUNCTION(name, result, parameters, work, form, text) \
  case FunctionId::name:                                     \
    work;
#include "interpreter/dialects/sinumerik/vocabulary/functions.def"
#undef FUNCTION
#undef Called
#undef OfTwo
#undef OfOne
  }
  contract_violated("a function of numbers is a step of its own", __FILE__, __LINE__);
}

MaybeFailure FunctionCaller::call(MaybeFailure (*function)(Operands&, const Op&, Arguments),
                                  const Op& op) {
  return function(operands_, op, operands_.arguments_of(op));
}

MaybeFailure FunctionCaller::call(MaybeFailure (*function)(Channel&, Operands&, const Op&,
                                                           Arguments),
                                  const Op& op) {
  return function(channel_, operands_, op, operands_.arguments_of(op));
}

MaybeFailure FunctionCaller::call(MaybeFailure (*function)(CalledPrograms&, Operands&, const Op&,
                                                           Arguments),
                                  const Op& op) {
  return function(programs_, operands_, op, operands_.arguments_of(op));
}

MaybeFailure FunctionCaller::call(MaybeFailure (*function)(const Globals&, Operands&, const Op&,
                                                           Arguments),
                                  const Op& op) {
  return function(globals_, operands_, op, operands_.arguments_of(op));
}

MaybeFailure FunctionCaller::call(MaybeFailure (*function)(const Globals&, CalledPrograms&,
                                                           Operands&, const Op&, Arguments),
                                  const Op& op) {
  return function(globals_, programs_, operands_, op, operands_.arguments_of(op));
}

namespace function {

std::string name_of(const Op& op) {
  return std::string(info(static_cast<FunctionId>(op.detail)).name);
}

/// BOUND(low, high, a)
MaybeFailure bounded(Operands& at, const Op& op, Arguments list) {
  const double low = at.number(list[0]);
  const double high = at.number(list[1]);
  if (MaybeFailure wrong = failure(wrong_bounds(low, high))) {
    return wrong;
  }
  at.number(op.result) = std::clamp(at.number(list[2]), low, high);
  return std::nullopt;
}

MaybeFailure is_geometry_axis(Operands& at, const Op& op, Arguments list) {
  const double axis = at.number(list[0]);
  at.number(op.result) = axis >= 1.0 && axis <= 3.0 ? 1.0 : 0.0;
  return std::nullopt;
}

MaybeFailure name_of_axis(Operands& at, const Op& op, Arguments list) {
  at.text(op.result) = shown(Type::Axis, at.number(list[0]));
  return std::nullopt;
}

/// MODAXVAL(axis, value)
MaybeFailure modulo_place(Operands& at, const Op& op, Arguments list) {
  const double axis = at.number(list[0]);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex, "MODAXVAL");
  }
  const double value = at.number(list[1]);
  at.number(op.result) =
      is_rotary_axis(static_cast<int>(axis)) ? machine::within_turn(value) : value;
  return std::nullopt;
}

/// SPRINT(format, values...)
MaybeFailure formatted_text(Operands& at, const Op& op, Arguments list) {
  std::vector<SprintValue> values;
  for (const Argument& argument : list.subspan(1)) {
    SprintValue value;
    value.type = argument.type;
    if (argument.type == Type::String) {
      value.text = at.text(argument.value);
    } else if (is_held_as_number(argument.type)) {
      value.number = at.number(argument);
    } else {
      return failure(AlarmId::BadArguments, "SPRINT");
    }
    values.push_back(std::move(value));
  }
  const auto made = sprint(at.text(list[0].value), values);
  if (!made) {
    return failure(AlarmId::BadArguments, "SPRINT: the format does not fit its values");
  }
  at.text(op.result) = *made;
  return std::nullopt;
}

MaybeFailure number_of_text(Operands& at, const Op& op, Arguments list) {
  const std::string& given = at.text(list[0].value);
  const auto value = number_in(given);
  if (!value) {
    return failure(AlarmId::NotANumber, fmt::format("\"{}\"", given));
  }
  at.number(op.result) = *value;
  return std::nullopt;
}

MaybeFailure shows_number(Operands& at, const Op& op, Arguments list) {
  at.number(op.result) = number_in(at.text(list[0].value)) ? 1.0 : 0.0;
  return std::nullopt;
}

MaybeFailure length_of_text(Operands& at, const Op& op, Arguments list) {
  at.number(op.result) = static_cast<double>(at.text(list[0].value).size());
  return std::nullopt;
}

MaybeFailure upper_case(Operands& at, const Op& op, Arguments list) {
  std::string all = upper(at.text(list[0].value));
  at.text(op.result) = std::move(all);
  return std::nullopt;
}

MaybeFailure lower_case(Operands& at, const Op& op, Arguments list) {
  std::string all = at.text(list[0].value);
  std::ranges::transform(all, all.begin(), small_letter);
  at.text(op.result) = std::move(all);
  return std::nullopt;
}

MaybeFailure axis_of_name(const Globals& globals, Operands& at, const Op& op, Arguments list) {
  const std::string& name = at.text(list[0].value);
  const int axis = globals.axis(upper(name));
  if (axis < 0) {
    return failure(AlarmId::NoAxisName, fmt::format("\"{}\"", name));
  }
  at.number(op.result) = axis;
  return std::nullopt;
}

MaybeFailure knows_variable(const Globals& globals, Operands& at, const Op& op, Arguments list) {
  at.number(op.result) = names_variable(globals, at.program(), at.text(list[0].value)) ? 1.0 : 0.0;
  return std::nullopt;
}

MaybeFailure knows_file(CalledPrograms& programs, Operands& at, const Op& op, Arguments list) {
  const std::string& path = at.text(list[0].value);
  const bool is_there = programs.is_written(path) || programs.find(path) != nullptr;
  at.number(op.result) = is_there ? 1.0 : 0.0;
  return std::nullopt;
}

/// SUBSTR(text, first, length)
MaybeFailure part_of_text(Operands& at, const Op& op, Arguments list) {
  const std::string& in = at.text(list[0].value);
  const double first = rounded(at.number(list[1]));
  const double most = static_cast<double>(in.size());
  const double length = list.size() > 2 ? std::min(rounded(at.number(list[2])), most) : most;
  const bool inside = first >= 0.0 && first < most && length > 0.0;
  std::string part =
      inside ? in.substr(static_cast<std::size_t>(first), static_cast<std::size_t>(length)) : "";
  at.text(op.result) = std::move(part);
  return std::nullopt;
}

/// INDEX(text, character)
MaybeFailure first_place(Operands& at, const Op& op, Arguments list) {
  if (MaybeFailure wrong = needs_one_character(at, op, list)) {
    return wrong;
  }
  return take_place(at, op, at.text(list[0].value).find(at.text(list[1].value)));
}

/// RINDEX(text, character)
MaybeFailure last_place(Operands& at, const Op& op, Arguments list) {
  if (MaybeFailure wrong = needs_one_character(at, op, list)) {
    return wrong;
  }
  return take_place(at, op, at.text(list[0].value).rfind(at.text(list[1].value)));
}

/// MINDEX(text, characters)
MaybeFailure first_of_set(Operands& at, const Op& op, Arguments list) {
  return take_place(at, op, at.text(list[0].value).find_first_of(at.text(list[1].value)));
}

/// MATCH(text, part)
MaybeFailure place_of_part(Operands& at, const Op& op, Arguments list) {
  return take_place(at, op, at.text(list[0].value).find(at.text(list[1].value)));
}

}  // namespace function
}  // namespace g31::sinumerik

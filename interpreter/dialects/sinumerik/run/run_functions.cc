#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/runner.h"
#include "machine/base/contract.h"
#include "machine/base/letters.h"

namespace g31::sinumerik {

MaybeFailure Runner::call_function(const Op& op) {
  const Arguments list = arguments_of(op);
  switch (static_cast<FunctionId>(op.detail)) {
#define OfOne(f) break
#define OfTwo(f) break
#define Called(f) return f(op, list)
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

std::string Runner::function_name(const Op& op) {
  return std::string(info(static_cast<FunctionId>(op.detail)).name);
}

/// BOUND(low, high, a)
MaybeFailure Runner::bounded(const Op& op, Arguments list) {
  const double low = number(list[0].value);
  const double high = number(list[1].value);
  if (low > high) {
    return failure(AlarmId::BadArguments, "BOUND: the lower limit is above the upper one");
  }
  number(op.result) = std::clamp(number(list[2].value), low, high);
  return std::nullopt;
}

MaybeFailure Runner::is_geometry_axis(const Op& op, Arguments list) {
  const double axis = number(list[0].value);
  number(op.result) = axis >= 1.0 && axis <= 3.0 ? 1.0 : 0.0;
  return std::nullopt;
}

MaybeFailure Runner::name_of_axis(const Op& op, Arguments list) {
  text(op.result) = shown(Type::Axis, number(list[0].value));
  return std::nullopt;
}

/// MODAXVAL(axis, value)
MaybeFailure Runner::modulo_place(const Op& op, Arguments list) {
  const double axis = number(list[0].value);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex, "MODAXVAL");
  }
  constexpr double kTurn = 360.0;
  const double value = number(list[1].value);
  number(op.result) =
      !is_rotary_axis(static_cast<int>(axis)) ? value : value - kTurn * std::floor(value / kTurn);
  return std::nullopt;
}

/// SPRINT(format, values...)
MaybeFailure Runner::formatted_text(const Op& op, Arguments list) {
  std::vector<SprintValue> values;
  for (const Argument& argument : list.subspan(1)) {
    SprintValue value;
    value.type = argument.type;
    if (argument.type == Type::String) {
      value.text = text(argument.value);
    } else if (is_held_as_number(argument.type)) {
      value.number = number(argument.value);
    } else {
      return failure(AlarmId::BadArguments, "SPRINT");
    }
    values.push_back(std::move(value));
  }
  const auto made = sprint(text(list[0].value), values);
  if (!made) {
    return failure(AlarmId::BadArguments, "SPRINT: the format does not fit its values");
  }
  text(op.result) = *made;
  return std::nullopt;
}

MaybeFailure Runner::number_of_text(const Op& op, Arguments list) {
  const std::string& given = text(list[0].value);
  const auto value = number_in(given);
  if (!value) {
    return failure(AlarmId::NotANumber, fmt::format("\"{}\"", given));
  }
  number(op.result) = *value;
  return std::nullopt;
}

MaybeFailure Runner::shows_number(const Op& op, Arguments list) {
  number(op.result) = number_in(text(list[0].value)) ? 1.0 : 0.0;
  return std::nullopt;
}

MaybeFailure Runner::length_of_text(const Op& op, Arguments list) {
  number(op.result) = static_cast<double>(text(list[0].value).size());
  return std::nullopt;
}

MaybeFailure Runner::upper_case(const Op& op, Arguments list) {
  std::string all = upper(text(list[0].value));
  text(op.result) = std::move(all);
  return std::nullopt;
}

MaybeFailure Runner::lower_case(const Op& op, Arguments list) {
  std::string all = text(list[0].value);
  std::ranges::transform(all, all.begin(), small_letter);
  text(op.result) = std::move(all);
  return std::nullopt;
}

MaybeFailure Runner::axis_of_name(const Op& op, Arguments list) {
  const std::string& name = text(list[0].value);
  const int axis = programs_.globals().axis(upper(name));
  if (axis < 0) {
    return failure(AlarmId::NoAxisName, fmt::format("\"{}\"", name));
  }
  number(op.result) = axis;
  return std::nullopt;
}

MaybeFailure Runner::knows_variable(const Op& op, Arguments list) {
  number(op.result) = is_variable(text(list[0].value)) ? 1.0 : 0.0;
  return std::nullopt;
}

MaybeFailure Runner::knows_file(const Op& op, Arguments list) {
  const std::string& path = text(list[0].value);
  const bool is_there =
      channel_.files.contains(file_name(path)) || programs_.find(path, near()) != nullptr;
  number(op.result) = is_there ? 1.0 : 0.0;
  return std::nullopt;
}

/// SUBSTR(text, first, length)
MaybeFailure Runner::part_of_text(const Op& op, Arguments list) {
  const std::string& in = text(list[0].value);
  const double at = rounded(number(list[1].value));
  const double most = static_cast<double>(in.size());
  const double length = list.size() > 2 ? std::min(rounded(number(list[2].value)), most) : most;
  const bool inside = at >= 0.0 && at < most && length > 0.0;
  std::string part =
      inside ? in.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(length)) : "";
  text(op.result) = std::move(part);
  return std::nullopt;
}

/// A place in a text, from 0; -1: nowhere.
MaybeFailure Runner::take_place(const Op& op, std::size_t at) {
  number(op.result) = at == std::string::npos ? -1.0 : static_cast<double>(at);
  return std::nullopt;
}

MaybeFailure Runner::needs_one_character(const Op& op, Arguments list) {
  return text(list[1].value).size() == 1
             ? std::nullopt
             : std::optional(failure(AlarmId::BadArguments, function_name(op) + ": one character"));
}

/// INDEX(text, character)
MaybeFailure Runner::first_place(const Op& op, Arguments list) {
  if (MaybeFailure wrong = needs_one_character(op, list)) {
    return wrong;
  }
  return take_place(op, text(list[0].value).find(text(list[1].value)));
}

/// RINDEX(text, character)
MaybeFailure Runner::last_place(const Op& op, Arguments list) {
  if (MaybeFailure wrong = needs_one_character(op, list)) {
    return wrong;
  }
  return take_place(op, text(list[0].value).rfind(text(list[1].value)));
}

/// MINDEX(text, characters)
MaybeFailure Runner::first_of_set(const Op& op, Arguments list) {
  return take_place(op, text(list[0].value).find_first_of(text(list[1].value)));
}

/// MATCH(text, part)
MaybeFailure Runner::place_of_part(const Op& op, Arguments list) {
  return take_place(op, text(list[0].value).find(text(list[1].value)));
}

/// R1, NAME or NAME[..]: whether there is one of this name.
bool Runner::is_variable(std::string_view name) {
  const std::string stem = upper(name.substr(0, name.find('[')));
  const bool is_r = stem.size() > 1 && stem.front() == 'R' &&
                    std::ranges::all_of(stem.substr(1), [](char c) { return is_digit(c); });
  return is_r || level().program->locals.contains(stem) ||
         programs_.globals().find(stem) != nullptr || find_system_variable(stem).has_value();
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/runner.h"

namespace g31::sinumerik {
namespace {

using Form = Argument::Form;

double place_or_none(std::size_t at) {
  return at == std::string::npos ? -1.0 : static_cast<double>(at);
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// CROTS; one angle alone turns as CROT does.
MaybeFailure turn_by_two(Frame& result, const Eigen::Vector3d& degrees,
                         const std::array<bool, 3>& given) {
  const auto count = std::count(given.begin(), given.end(), true);
  if (count > 2) {
    return failure(AlarmId::ArgumentCount, "CROTS");
  }
  if (count < 2) {
    result.set_angles(degrees);
    return std::nullopt;
  }
  const auto missing =
      static_cast<int>(std::find(given.begin(), given.end(), false) - given.begin());
  const int first = (missing + 1) % 3;
  result.set_solid_angles(first, degrees[first], degrees[(first + 1) % 3]);
  return std::nullopt;
}

}  // namespace

MaybeFailure Runner::call_function(const Op& op) {
  const auto id = static_cast<FunctionId>(op.detail);
  const Arguments list = arguments_of(op);
  if (id == FunctionId::BOUND) {
    const double low = number(list[0].value);
    const double high = number(list[1].value);
    if (low > high) {
      return failure(AlarmId::BadArguments, "BOUND: the lower limit is above the upper one");
    }
    number(op.result) = std::clamp(number(list[2].value), low, high);
    return std::nullopt;
  }
  if (id == FunctionId::ISAXIS) {
    const double axis = number(list[0].value);
    number(op.result) = axis >= 1.0 && axis <= 3.0 ? 1.0 : 0.0;
    return std::nullopt;
  }
  if (id >= FunctionId::CTRANS) {
    return frame_function(id, op, list);
  }
  if (id == FunctionId::SPRINT) {
    return sprint_function(op, list);
  }
  if (id == FunctionId::MODAXVAL) {
    return modulo_place(op, list);
  }
  if (id == FunctionId::CALCDAT) {
    return circle_function(op, list);
  }
  if (id >= FunctionId::GETT) {
    return tool_function(id, op, list);
  }
  if (id == FunctionId::AXSTRING) {
    text(op.result) = shown(Type::Axis, number(list[0].value));
    return std::nullopt;
  }
  return text_function(id, op, list);
}

/// MODAXVAL(axis, value)
MaybeFailure Runner::modulo_place(const Op& op, Arguments list) {
  const double axis = number(list[0].value);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex, "MODAXVAL");
  }
  constexpr double kTurn = 360.0;
  const double value = number(list[1].value);
  number(op.result) = axis < 3.0 ? value : value - kTurn * std::floor(value / kTurn);
  return std::nullopt;
}

MaybeFailure Runner::sprint_function(const Op& op, Arguments list) {
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

MaybeFailure Runner::text_function(FunctionId id, const Op& op, Arguments list) {
  const std::string first = text(list[0].value);
  switch (static_cast<int>(id)) {
    case static_cast<int>(FunctionId::NUMBER): {
      const auto value = number_in(first);
      if (!value) {
        return failure(AlarmId::NotANumber, fmt::format("\"{}\"", first));
      }
      number(op.result) = *value;
      return std::nullopt;
    }
    case static_cast<int>(FunctionId::ISNUMBER):
      number(op.result) = number_in(first) ? 1.0 : 0.0;
      return std::nullopt;
    case static_cast<int>(FunctionId::STRLEN):
      number(op.result) = static_cast<double>(first.size());
      return std::nullopt;
    case static_cast<int>(FunctionId::TOUPPER):
      text(op.result) = upper(first);
      return std::nullopt;
    case static_cast<int>(FunctionId::TOLOWER):
      text(op.result) = first;
      std::ranges::transform(text(op.result), text(op.result).begin(), lower);
      return std::nullopt;
    case static_cast<int>(FunctionId::AXNAME): {
      const int axis = first.size() == 1 ? axis_index(upper(first.front())) : -1;
      if (axis < 0) {
        return failure(AlarmId::NoAxisName, fmt::format("\"{}\"", first));
      }
      number(op.result) = axis;
      return std::nullopt;
    }
    case static_cast<int>(FunctionId::ISVAR):
      number(op.result) = is_variable(first) ? 1.0 : 0.0;
      return std::nullopt;
    case static_cast<int>(FunctionId::ISFILE):
      number(op.result) =
          channel_.files.contains(file_name(first)) || programs_.find(first, near()) != nullptr
              ? 1.0
              : 0.0;
      return std::nullopt;
    default:
      return search_function(id, op, list);
  }
}

MaybeFailure Runner::search_function(FunctionId id, const Op& op, Arguments list) {
  const std::string& in = text(list[0].value);
  if (id == FunctionId::SUBSTR) {
    const double at = rounded(number(list[1].value));
    const double most = static_cast<double>(in.size());
    const double length = list.size() > 2 ? std::min(rounded(number(list[2].value)), most) : most;
    const bool inside = at >= 0.0 && at < most && length > 0.0;
    std::string part =
        inside ? in.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(length)) : "";
    text(op.result) = std::move(part);
    return std::nullopt;
  }
  const std::string& wanted = text(list[1].value);
  const bool wants_one = id == FunctionId::INDEX || id == FunctionId::RINDEX;
  if (wants_one && wanted.size() != 1) {
    return failure(AlarmId::BadArguments, fmt::format("{}: one character", info(id).name));
  }
  const std::size_t at = id == FunctionId::RINDEX   ? in.rfind(wanted)
                         : id == FunctionId::MINDEX ? in.find_first_of(wanted)
                                                    : in.find(wanted);
  number(op.result) = place_or_none(at);
  return std::nullopt;
}

/// R1, NAME or NAME[..]: whether there is one of this name.
bool Runner::is_variable(std::string_view name) {
  const std::string stem = upper(name.substr(0, name.find('[')));
  const bool is_r = stem.size() > 1 && stem.front() == 'R' &&
                    std::ranges::all_of(stem.substr(1), [](char c) { return is_digit(c); });
  return is_r || level().program->locals.contains(stem) ||
         programs_.globals().find(stem) != nullptr || find_system_variable(stem).has_value();
}

MaybeFailure Runner::frame_function(FunctionId id, const Op& op, Arguments list) {
  Frame result;
  if (id == FunctionId::INVFRAME) {
    result = frame(list[0].value).inverse();
  } else if (id == FunctionId::MEAFRAME) {
    if (MaybeFailure wrong = measured_frame(result, list)) {
      return wrong;
    }
  } else if (id == FunctionId::CRPL) {
    const double which = rounded(number(list[0].value));
    if (!(which >= 0.0 && which <= 3.0)) {
      return failure(AlarmId::BadArguments, "CRPL: the plane is 0 to 3");
    }
    constexpr int kNormals[] = {0, 2, 1, 0};
    const auto row = static_cast<std::size_t>(which);
    const int normal = row == 0 ? channel_.plane().normal : kNormals[row];
    result.set_component(normal, Component::Rotation, number(list[1].value));
  } else if (MaybeFailure wrong = frame_of_pairs(id, result, list)) {
    return wrong;
  }
  frame(op.result) = result;
  return std::nullopt;
}

/// Axes and their values in turn; CMIRROR has axes only.
MaybeFailure Runner::frame_of_pairs(FunctionId id, Frame& result, Arguments list) {
  const bool mirrors = id == FunctionId::CMIRROR;
  const std::size_t step = mirrors ? 1 : 2;
  if (list.size() % step != 0) {
    return failure(AlarmId::ArgumentCount, std::string(info(id).name));
  }
  const bool turns = id == FunctionId::CROT || id == FunctionId::CROTS;
  Eigen::Vector3d degrees = Eigen::Vector3d::Zero();
  std::array<bool, 3> given = {};
  for (std::size_t i = 0; i < list.size(); i += step) {
    const double axis = list[i].type == Type::Axis ? number(list[i].value) : kNoAxis;
    if (axis < 0.0 || (!mirrors && !is_number(list[i + 1].type))) {
      return failure(AlarmId::NotAnAxis, std::string(info(id).name));
    }
    const int which = static_cast<int>(axis);
    const double value = mirrors ? 1.0 : number(list[i + 1].value);
    if (turns && which < 3) {
      degrees[which] = value;
      given[static_cast<std::size_t>(which)] = true;
    } else if (!turns) {
      const Component component = id == FunctionId::CTRANS   ? Component::Coarse
                                  : id == FunctionId::CFINE  ? Component::Fine
                                  : id == FunctionId::CSCALE ? Component::Scale
                                                             : Component::Mirror;
      result.set_component(which, component, channel_.stored_component(which, component, value));
    }
  }
  if (id == FunctionId::CROT) {
    result.set_angles(degrees);
  } else if (id == FunctionId::CROTS) {
    return turn_by_two(result, degrees, given);
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik

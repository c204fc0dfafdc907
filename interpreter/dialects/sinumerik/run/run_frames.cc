// Functions that make frames.

#include <algorithm>
#include <array>

#include "interpreter/dialects/sinumerik/run/runner.h"

namespace g31::sinumerik {
namespace {

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

/// Axes and their values in turn.
Result<std::vector<Runner::AxisValue>, Failure> Runner::axis_values(const Op& op, Arguments list) {
  if (list.size() % 2 != 0) {
    return failure(AlarmId::ArgumentCount, function_name(op));
  }
  std::vector<AxisValue> all;
  for (std::size_t i = 0; i < list.size(); i += 2) {
    const double axis = list[i].type == Type::Axis ? number(list[i].value) : kNoAxis;
    if (axis < 0.0 || !is_number(list[i + 1].type)) {
      return failure(AlarmId::NotAnAxis, function_name(op));
    }
    if (axis == kSpindleAxis) {
      continue;
    }
    if (!has_frame(static_cast<int>(axis))) {
      return failure(AlarmId::BadAxisIndex);
    }
    all.push_back({static_cast<int>(axis), number(list[i + 1].value)});
  }
  return all;
}

MaybeFailure Runner::frame_of_components(const Op& op, Arguments list, Component component) {
  const auto values = axis_values(op, list);
  if (!values) {
    return values.error();
  }
  Frame result;
  for (const auto& [axis, value] : values.value()) {
    if (MaybeFailure wrong = channel_.set_component(axis, component, value, result)) {
      return wrong;
    }
  }
  frame(op.result) = result;
  return std::nullopt;
}

MaybeFailure Runner::shift_frame(const Op& op, Arguments list) {
  return frame_of_components(op, list, Component::Coarse);
}

MaybeFailure Runner::fine_shift_frame(const Op& op, Arguments list) {
  return frame_of_components(op, list, Component::Fine);
}

MaybeFailure Runner::scale_frame(const Op& op, Arguments list) {
  return frame_of_components(op, list, Component::Scale);
}

/// CMIRROR(axis,...)
MaybeFailure Runner::mirror_frame(const Op& op, Arguments list) {
  Frame result;
  for (const Argument& argument : list) {
    const double axis = argument.type == Type::Axis ? number(argument.value) : kNoAxis;
    if (axis < 0.0) {
      return failure(AlarmId::NotAnAxis, function_name(op));
    }
    if (has_frame(static_cast<int>(axis))) {
      result.set_component(static_cast<int>(axis), Component::Mirror, 1.0);
    }
  }
  frame(op.result) = result;
  return std::nullopt;
}

/// CROT(axis,angle,...): rotary axes turn nothing.
MaybeFailure Runner::turn_frame(const Op& op, Arguments list) {
  const auto values = axis_values(op, list);
  if (!values) {
    return values.error();
  }
  Eigen::Vector3d degrees = Eigen::Vector3d::Zero();
  for (const auto& [axis, value] : values.value()) {
    if (axis < 3) {
      degrees[axis] = value;
    }
  }
  Frame result;
  result.set_angles(degrees);
  frame(op.result) = result;
  return std::nullopt;
}

MaybeFailure Runner::solid_turn_frame(const Op& op, Arguments list) {
  const auto values = axis_values(op, list);
  if (!values) {
    return values.error();
  }
  Eigen::Vector3d degrees = Eigen::Vector3d::Zero();
  std::array<bool, 3> given = {};
  for (const auto& [axis, value] : values.value()) {
    if (axis < 3) {
      degrees[axis] = value;
      given[static_cast<std::size_t>(axis)] = true;
    }
  }
  Frame result;
  if (MaybeFailure wrong = turn_by_two(result, degrees, given)) {
    return wrong;
  }
  frame(op.result) = result;
  return std::nullopt;
}

/// CRPL(plane, angle)
MaybeFailure Runner::plane_turn_frame(const Op& op, Arguments list) {
  const double which = rounded(number(list[0].value));
  if (!(which >= 0.0 && which <= 3.0)) {
    return failure(AlarmId::BadArguments, "CRPL: the plane is 0 to 3");
  }
  constexpr int kNormals[] = {0, 2, 1, 0};
  const auto row = static_cast<std::size_t>(which);
  const int normal = row == 0 ? channel_.plane().normal : kNormals[row];
  Frame result;
  result.set_component(normal, Component::Rotation, number(list[1].value));
  frame(op.result) = result;
  return std::nullopt;
}

MaybeFailure Runner::inverse_frame(const Op& op, Arguments list) {
  frame(op.result) = frame(list[0].value).inverse();
  return frame(op.result).is_within_limits()
             ? std::nullopt
             : std::optional(failure(AlarmId::ValueOutOfLimits, "the inverse of a frame"));
}

}  // namespace g31::sinumerik

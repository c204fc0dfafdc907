// Functions that make frames.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

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

struct AxisValue {
  int axis = 0;
  double value = 0.0;
};

/// Axes and their values in turn.
Result<std::vector<AxisValue>, Failure> axis_values(Operands& at, const Op& op, Arguments list) {
  std::vector<AxisValue> all;
  for (std::size_t i = 0; i + 1 < list.size(); i += 2) {
    const double axis = at.number(list[i]);
    if (axis < 0.0) {
      return failure(AlarmId::NotAnAxis, function::name_of(op));
    }
    if (axis == kSpindleAxis) {
      continue;
    }
    if (!has_frame(static_cast<int>(axis))) {
      return failure(AlarmId::BadAxisIndex);
    }
    all.push_back({static_cast<int>(axis), at.number(list[i + 1])});
  }
  return all;
}

MaybeFailure frame_of_components(Channel& channel, Operands& at, const Op& op, Arguments list,
                                 Component component) {
  const auto values = axis_values(at, op, list);
  if (!values) {
    return values.error();
  }
  Frame result;
  for (const auto& [axis, value] : values.value()) {
    if (MaybeFailure wrong = channel.set_component(axis, component, value, result)) {
      return wrong;
    }
  }
  at.frame(op.result) = result;
  return std::nullopt;
}

/// A frame in force, by the name that ADDFRAME takes.
struct FrameInForce {
  std::string name;
  Frame* frame = nullptr;
};

/// From the outermost one; basic frames that do not count are not among them.
std::vector<FrameInForce> frames_in_force(Channel& channel) {
  FrameSet& now = channel.frames_now;
  std::vector<FrameInForce> all = {
      {"$P_PARTFRAME", &now.part}, {"$P_SETFRAME", &now.set}, {"$P_EXTFRAME", &now.external}};
  const auto add = [&](std::string_view name, auto& frames, unsigned mask, double count) {
    for (std::size_t i = 0; i < frames.size() && static_cast<double>(i) < count; ++i) {
      if ((mask >> i & 1U) != 0) {
        all.push_back({fmt::format("{}[{}]", name, i), &frames[i]});
      }
    }
  };
  add("$P_NCBFRAME", now.global, now.masks.global, channel.global_base_frames());
  add("$P_CHBFRAME", now.channel, now.masks.channel, channel.base_frames());
  all.push_back({"$P_IFRAME", &channel.settable_now});
  all.push_back({"$P_TOOLFRAME", &now.tool});
  all.push_back({"$P_WPFRAME", &now.workpiece});
  all.push_back({"$P_TRAFRAME", &now.transformation});
  all.push_back({"$P_PFRAME", &channel.program_frame});
  all.push_back({"$P_CYCFRAME", &now.cycle});
  return all;
}

}  // namespace

namespace function {

/// ADDFRAME(frame, name of the target).  Source: basic functions 09/2011, K2 10.5, additive frame
/// in the frame chain: the new complete frame is the old one with the additional one behind it.
MaybeFailure add_frame(Channel& channel, Operands& at, const Op& op, Arguments list) {
  constexpr double kWrongTarget = 1.0;
  constexpr double kNotThere = 2.0;
  const std::string name = upper(at.text(list[1].value));
  const std::vector<FrameInForce> all = frames_in_force(channel);
  const auto target = std::ranges::find(all, name, &FrameInForce::name);
  if (target == all.end()) {
    const auto row = find_system_variable(name.substr(0, name.find('[')));
    const bool is_frame = row && row->row->type == Type::Frame && row->row->access == Access::Write;
    const bool is_stored = is_frame && !name.substr(0, name.find('[')).ends_with("FRAME");
    if (is_stored) {
      return failure(AlarmId::NotImplemented, "ADDFRAME into a stored frame, " + name);
    }
    at.number(op.result) = is_frame ? kNotThere : kWrongTarget;
    return std::nullopt;
  }
  Frame inner;
  for (auto behind = std::next(target); behind != all.end(); ++behind) {
    chain(inner, *behind->frame);
  }
  Frame result = *target->frame;
  chain(result, inner);
  chain(result, at.frame(list[0].value));
  chain(result, inner.inverse());
  if (!result.is_within_limits()) {
    return failure(AlarmId::ValueOutOfLimits, "ADDFRAME");
  }
  *target->frame = result;
  channel.frame_written();
  at.number(op.result) = 0.0;
  return std::nullopt;
}

MaybeFailure shift_frame(Channel& channel, Operands& at, const Op& op, Arguments list) {
  return frame_of_components(channel, at, op, list, Component::Coarse);
}

MaybeFailure fine_shift_frame(Channel& channel, Operands& at, const Op& op, Arguments list) {
  return frame_of_components(channel, at, op, list, Component::Fine);
}

MaybeFailure scale_frame(Channel& channel, Operands& at, const Op& op, Arguments list) {
  return frame_of_components(channel, at, op, list, Component::Scale);
}

/// CMIRROR(axis,...)
MaybeFailure mirror_frame(Operands& at, const Op& op, Arguments list) {
  Frame result;
  for (const Argument& argument : list) {
    const double axis = argument.type == Type::Axis ? at.number(argument) : kNoAxis;
    if (axis < 0.0) {
      return failure(AlarmId::NotAnAxis, function::name_of(op));
    }
    if (has_frame(static_cast<int>(axis))) {
      result.set_component(static_cast<int>(axis), Component::Mirror, 1.0);
    }
  }
  at.frame(op.result) = result;
  return std::nullopt;
}

/// CROT(axis,angle,...): rotary axes turn nothing.
MaybeFailure turn_frame(Operands& at, const Op& op, Arguments list) {
  const auto values = axis_values(at, op, list);
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
  at.frame(op.result) = result;
  return std::nullopt;
}

MaybeFailure solid_turn_frame(Operands& at, const Op& op, Arguments list) {
  const auto values = axis_values(at, op, list);
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
  at.frame(op.result) = result;
  return std::nullopt;
}

/// CRPL(plane, angle)
MaybeFailure plane_turn_frame(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const double which = rounded(at.number(list[0]));
  if (!(which >= 0.0 && which <= 3.0)) {
    return failure(AlarmId::BadArguments, "CRPL: the plane is 0 to 3");
  }
  constexpr int kNormals[] = {0, 2, 1, 0};
  const auto row = static_cast<std::size_t>(which);
  const int normal = row == 0 ? channel.plane().normal : kNormals[row];
  Frame result;
  result.set_component(normal, Component::Rotation, at.number(list[1]));
  at.frame(op.result) = result;
  return std::nullopt;
}

MaybeFailure inverse_frame(Operands& at, const Op& op, Arguments list) {
  at.frame(op.result) = at.frame(list[0].value).inverse();
  return at.frame(op.result).is_within_limits()
             ? std::nullopt
             : MaybeFailure(failure(AlarmId::ValueOutOfLimits, "the inverse of a frame"));
}

}  // namespace function
}  // namespace g31::sinumerik

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

bool has_word(const Block& block, int axis) {
  return has_frame(axis) && block.words[address_of_axis(axis)].present;
}

/// What a code makes of its words.
struct FrameCode {
  std::string_view name;
  Component component;
  bool adds;  ///< to the frame in force
};

constexpr FrameCode kFrameCodes[] = {
    {"TRANS", Component::Coarse, false},  {"ATRANS", Component::Coarse, true},
    {"ROT", Component::Rotation, false},  {"AROT", Component::Rotation, true},
    {"ROTS", Component::Rotation, false}, {"AROTS", Component::Rotation, true},
    {"SCALE", Component::Scale, false},   {"ASCALE", Component::Scale, true},
    {"MIRROR", Component::Mirror, false}, {"AMIRROR", Component::Mirror, true},
    {"G58", Component::Coarse, false},    {"G59", Component::Fine, false},
};

const FrameCode& frame_code(const GCode& code) {
  const auto* const found = std::ranges::find(kFrameCodes, code.name, &FrameCode::name);
  G31_EXPECTS(found != std::end(kFrameCodes));
  return *found;
}

/// What the words of the block make, to be chained or taken alone.
Result<Frame, Failure> frame_of_words(const Channel& channel, const Block& block,
                                      Component component) {
  Frame frame;
  Eigen::Vector3d degrees = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < static_cast<int>(kAxisNumbers); ++axis) {
    if (!has_word(block, axis)) {
      continue;
    }
    if (is_further_axis(axis) && channel.further(axis) == nullptr) {
      return no_such_axis(axis);
    }
    const BlockWords::Word& word = block.words[address_of_axis(axis)];
    if (component == Component::Coarse) {
      frame.set_component(axis, component, channel.stored(axis, word.value));
    } else if (component == Component::Scale) {
      if (MaybeFailure wrong = channel.set_component(axis, component, word.value, frame)) {
        return *wrong;
      }
    } else if (component == Component::Mirror) {
      frame.set_component(axis, component, 1.0);
    } else if (is_linear_axis(axis)) {
      degrees[axis] = word.value;
    } else {
      return failure(AlarmId::BadAxisIndex, fmt::format("ROT {}", letter_of_axis(axis)));
    }
  }
  if (block.words.has(Address::PlaneRotation)) {
    if (component != Component::Rotation || !degrees.isZero(0.0)) {
      return failure(AlarmId::UnexpectedParameter, "RPL");
    }
    degrees[channel.plane().normal] = block.words[Address::PlaneRotation].value;
  }
  if (component == Component::Rotation) {
    frame.set_angles(degrees);
  }
  return frame;
}

/// The programmable frame is another one now.
MaybeFailure take_program_frame(Channel& channel) {
  channel.frames_changed();
  return channel.program_frame.is_within_limits()
             ? std::nullopt
             : MaybeFailure(failure(AlarmId::ValueOutOfLimits, "the programmable frame"));
}

}  // namespace

MaybeFailure shift_by_axis(Channel& channel, const Block& block, const GCode& code) {
  const Component part = frame_code(code).component;
  for (int axis = 0; axis < static_cast<int>(kAxisNumbers); ++axis) {
    if (has_word(block, axis)) {
      const double value = block.words[address_of_axis(axis)].value;
      channel.program_frame.set_component(axis, part, channel.stored(axis, value));
    }
  }
  channel.frames_changed();
  return std::nullopt;
}

MaybeFailure turn_by_solid_angles(Channel& channel, const Block& block, const GCode& code) {
  if (block.words.has(Address::PlaneRotation)) {
    return program_frame(channel, block, code);
  }
  int missing = -1;
  int given = 0;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const bool present = block.words.axis(axis).present;
    missing = present ? missing : axis;
    given += present ? 1 : 0;
  }
  if (given != 2) {
    return given == 1 ? program_frame(channel, block, code)
                      : MaybeFailure(failure(AlarmId::UnexpectedParameter,
                                             fmt::format("{} takes one or two angles", code.name)));
  }
  const int first = (missing + 1) % 3;
  Frame frame;
  frame.set_solid_angles(first, block.words.axis(first).value,
                         block.words.axis((first + 1) % 3).value);
  channel.program_frame = frame_code(code).adds ? channel.program_frame.chained(frame) : frame;
  return take_program_frame(channel);
}

MaybeFailure program_frame(Channel& channel, const Block& block, const GCode& code) {
  const FrameCode& made = frame_code(code);
  const auto frame = frame_of_words(channel, block, made.component);
  if (!frame) {
    return frame.error();
  }
  if (made.adds && made.component == Component::Coarse) {
    channel.program_frame.add_fine_shift(frame.value());
  } else {
    channel.program_frame =
        made.adds ? channel.program_frame.chained(frame.value()) : frame.value();
  }
  return take_program_frame(channel);
}

}  // namespace g31::sinumerik

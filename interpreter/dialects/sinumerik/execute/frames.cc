#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {
namespace {

/// What the words of the block make, to be chained or taken alone.
Result<Frame, Failure> frame_of_words(const Channel& channel, const Block& block,
                                      std::string_view kind) {
  Frame frame;
  Eigen::Vector3d degrees = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const BlockWords::Word& word = block.words.axis(axis);
    if (!word.present) {
      continue;
    }
    if (kind == "TRANS") {
      frame.set_component(axis, Component::Coarse, channel.stored(axis, word.value));
    } else if (kind == "SCALE") {
      if (word.value == 0.0) {
        return failure(AlarmId::ValueOutOfLimits, fmt::format("SCALE {}0", kAxisLetters[axis]));
      }
      frame.set_component(axis, Component::Scale, word.value);
    } else if (kind == "MIRROR") {
      frame.set_component(axis, Component::Mirror, 1.0);
    } else if (axis < 3) {
      degrees[axis] = word.value;
    } else {
      return failure(AlarmId::BadAxisIndex, fmt::format("ROT {}", kAxisLetters[axis]));
    }
  }
  if (block.words.has(Address::PlaneRotation)) {
    if (kind != "ROT" || !degrees.isZero(0.0)) {
      return failure(AlarmId::UnexpectedParameter, "RPL");
    }
    degrees[channel.plane().normal] = block.words[Address::PlaneRotation].value;
  }
  if (kind == "ROT") {
    frame.set_angles(degrees);
  }
  return frame;
}

}  // namespace

MaybeFailure program_frame(Channel& channel, const Block& block, const GCode& code) {
  const bool adds = code.name.front() == 'A';
  const std::string_view kind = adds ? code.name.substr(1) : code.name;
  const auto frame = frame_of_words(channel, block, kind);
  if (!frame) {
    return frame.error();
  }
  channel.program_frame = adds ? channel.program_frame.chained(frame.value()) : frame.value();
  channel.frames_changed();
  return std::nullopt;
}

}  // namespace g31::sinumerik

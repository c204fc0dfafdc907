#include <array>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

using Bases = std::array<Frame, FrameSet::kBases>;

/// $P_CHBFR[n] and the like; without an index 0.
/// @param count  MD28081 or MD18602
FramePlace base_of(Bases& all, const SystemAccess& access, double count) {
  const int which = access.indices.empty() ? 0 : access.indices.front();
  if (which < 0 || which >= static_cast<int>(all.size()) || which >= count) {
    return failure(AlarmId::IndexOne, fmt::format("basic frame {}", which));
  }
  return &all[static_cast<std::size_t>(which)];
}

MaybeFailure set_mask(Channel& channel, unsigned& mask, double value) {
  constexpr auto kAll = static_cast<double>(FrameSet::BaseMasks::kAll);
  if (!(value >= 0.0 && value <= kAll)) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("{:g}: 0 to {:g}", value, kAll));
  }
  mask = static_cast<unsigned>(value);
  channel.frame_written();
  return std::nullopt;
}

}  // namespace

Number base_mask(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.frames_now.masks.channel);
}

Number global_base_mask(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.frames_now.masks.global);
}

MaybeFailure set_base_mask(Channel& channel, const SystemAccess& /*access*/, double value) {
  return set_mask(channel, channel.frames_now.masks.channel, value);
}

MaybeFailure set_global_base_mask(Channel& channel, const SystemAccess& /*access*/, double value) {
  return set_mask(channel, channel.frames_now.masks.global, value);
}

FramePlace settable_frames(Channel& channel, const SystemAccess& access) {
  const int which = access.indices.front();
  if (which < 0 || which >= Channel::kSettableFrames) {
    return failure(AlarmId::IndexOne, fmt::format("$P_UIFR[{}]", which));
  }
  return &channel.settable[static_cast<std::size_t>(which)];
}

FramePlace stored_bases(Channel& channel, const SystemAccess& access) {
  return base_of(channel.stored_frames.channel, access, channel.base_frames());
}

FramePlace bases(Channel& channel, const SystemAccess& access) {
  return base_of(channel.frames_now.channel, access, channel.base_frames());
}

FramePlace stored_base(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.stored_frames.channel.front();
}

FramePlace base(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.frames_now.channel.front();
}

FramePlace settable_frame(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.settable_now;
}

FramePlace program_frame(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.program_frame;
}

FramePlace stored_global_bases(Channel& channel, const SystemAccess& access) {
  return base_of(channel.stored_frames.global, access, channel.global_base_frames());
}

FramePlace global_bases(Channel& channel, const SystemAccess& access) {
  return base_of(channel.frames_now.global, access, channel.global_base_frames());
}

WholeFrame active_base(Channel& channel, const SystemAccess& /*access*/) {
  return channel.frames_now.bases();
}

WholeFrame active_frame(Channel& channel, const SystemAccess& /*access*/) {
  return channel.active_frame();
}

}  // namespace g31::sinumerik::system

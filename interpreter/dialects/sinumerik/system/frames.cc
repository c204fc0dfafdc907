#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

/// Of $P_CHBFR[n] and $P_CHBFRAME[n].
FramePlace only_base(Frame& frame, const SystemAccess& access) {
  if (!access.indices.empty() && access.indices.front() != 0) {
    return failure(AlarmId::IndexOne, fmt::format("basic frame {}", access.indices.front()));
  }
  return &frame;
}

}  // namespace

FramePlace settable_frames(Channel& channel, const SystemAccess& access) {
  const int which = access.indices.front();
  if (which < 0 || which >= Channel::kSettableFrames) {
    return failure(AlarmId::IndexOne, fmt::format("$P_UIFR[{}]", which));
  }
  return &channel.settable[static_cast<std::size_t>(which)];
}

FramePlace stored_bases(Channel& channel, const SystemAccess& access) {
  return only_base(channel.stored_base, access);
}

FramePlace bases(Channel& channel, const SystemAccess& access) {
  return only_base(channel.base, access);
}

FramePlace stored_base(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.stored_base;
}

FramePlace base(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.base;
}

FramePlace settable_frame(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.settable_now;
}

FramePlace program_frame(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.program_frame;
}

FramePlace set_frame(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.set_frame;
}

FramePlace stored_set_frame(Channel& channel, const SystemAccess& /*access*/) {
  return &channel.stored_set_frame;
}

WholeFrame active_base(Channel& channel, const SystemAccess& /*access*/) {
  return channel.base;
}

WholeFrame active_frame(Channel& channel, const SystemAccess& /*access*/) {
  return channel.active_frame();
}

}  // namespace g31::sinumerik::system

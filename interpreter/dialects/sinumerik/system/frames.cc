#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik {
namespace {

/// Takes axis and component from the end of the indices, if they are there.
MaybeFailure split(SystemAccess& access) {
  if (access.indices.size() < 2) {
    return std::nullopt;
  }
  access.component = static_cast<Component>(access.indices.back());
  access.indices.pop_back();
  access.axis = access.indices.back();
  access.indices.pop_back();
  return access.axis < 0 ? std::optional(failure(AlarmId::BadAxisIndex)) : std::nullopt;
}

/// The frame that a program may write; nullptr: it is made of others.
Result<Frame*, Failure> stored_frame(Channel& channel, const SystemAccess& access) {
  switch (static_cast<int>(access.id)) {
    case static_cast<int>(SystemId::SettableFrames): {
      const int which = access.indices.front();
      if (which < 0 || which >= Channel::kSettableFrames) {
        return failure(AlarmId::IndexOne, fmt::format("$P_UIFR[{}]", which));
      }
      return &channel.settable[static_cast<std::size_t>(which)];
    }
    case static_cast<int>(SystemId::BaseFrames):
    case static_cast<int>(SystemId::BaseFramesNow):
      if (!access.indices.empty() && access.indices.front() != 0) {
        return failure(AlarmId::IndexOne, fmt::format("basic frame {}", access.indices.front()));
      }
      return access.id == SystemId::BaseFrames ? &channel.stored_base : &channel.base;
    case static_cast<int>(SystemId::FirstBaseFrame):
      return &channel.stored_base;
    case static_cast<int>(SystemId::BaseFrame):
      return &channel.base;
    case static_cast<int>(SystemId::SettableFrame):
      return &channel.settable_now;
    case static_cast<int>(SystemId::ProgramFrame):
      return &channel.program_frame;
    case static_cast<int>(SystemId::SetFrame):
      return &channel.set_frame;
    case static_cast<int>(SystemId::StoredSetFrame):
      return &channel.stored_set_frame;
    default:
      return static_cast<Frame*>(nullptr);
  }
}

}  // namespace

Result<Frame, Failure> frame_of(Channel& channel, SystemAccess& access) {
  if (MaybeFailure wrong = split(access)) {
    return *wrong;
  }
  const auto stored = stored_frame(channel, access);
  if (!stored) {
    return stored.error();
  }
  if (stored.value() != nullptr) {
    return *stored.value();
  }
  return access.id == SystemId::ActiveBase ? channel.base : channel.active_frame();
}

MaybeFailure set_frame(Channel& channel, SystemAccess access, const Frame& frame) {
  const auto stored = stored_frame(channel, access);
  if (!stored) {
    return stored.error();
  }
  *stored.value() = frame;
  channel.frames_changed();
  return std::nullopt;
}

}  // namespace g31::sinumerik

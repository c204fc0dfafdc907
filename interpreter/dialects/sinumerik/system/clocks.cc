#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik {
namespace {

/// The simulated clock starts at noon of this day.
constexpr int kFirstDay = 1;
constexpr int kNoon = 12 * 3600;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kCounterclockwise = 4.0;
constexpr double kStill = 5.0;

Result<Clocks::Timer*, Failure> timer_of(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (which < 0 || which >= Clocks::kTimers) {
    return failure(AlarmId::IndexOne, fmt::format("$AC_TIMER[{}]", which));
  }
  return &channel.clocks.timers[static_cast<std::size_t>(which)];
}

/// The offset of a counter that programs may set; nullptr: they may not.
double* offset_of(Clocks& clocks, SystemId id) {
  switch (static_cast<int>(id)) {
    case static_cast<int>(SystemId::OperatingTime):
      return &clocks.operating_offset;
    case static_cast<int>(SystemId::CycleTime):
      return &clocks.cycle_offset;
    case static_cast<int>(SystemId::CuttingTime):
      return &clocks.cutting_offset;
    case static_cast<int>(SystemId::SetupTime):
      return &clocks.setup_offset;
    case static_cast<int>(SystemId::PowerOnTime):
      return &clocks.power_on_offset;
    default:
      return nullptr;
  }
}

/// What a counter shows as long as nobody has set it.
double counted(const Channel& channel, SystemId id) {
  const double now = channel.port.time_s();
  switch (static_cast<int>(id)) {
    case static_cast<int>(SystemId::BlockTime):
      return now - channel.clocks.block_began;
    case static_cast<int>(SystemId::CuttingTime):
      return channel.clocks.cutting;
    case static_cast<int>(SystemId::SetupTime):
    case static_cast<int>(SystemId::PowerOnTime):
      return now / kSecondsPerMinute;
    default:
      return now;
  }
}

}  // namespace

bool is_time(SystemId id) {
  return id >= SystemId::BlockTime && id <= SystemId::PowerOnTime;
}

Result<double, Failure> time_of(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  if (access.id == SystemId::Timer) {
    const auto timer = timer_of(channel, access);
    return timer ? Result<double, Failure>(timer.value()->at(channel.port.time_s()))
                 : timer.error();
  }
  const double* const offset = offset_of(channel.clocks, access.id);
  return counted(channel, access.id) + (offset != nullptr ? *offset : 0.0);
}

MaybeFailure set_time(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  if (access.id != SystemId::Timer) {
    *offset_of(channel.clocks, access.id) = value - counted(channel, access.id);
    return std::nullopt;
  }
  const auto timer = timer_of(channel, access);
  if (!timer) {
    return timer.error();
  }
  const double now = channel.port.time_s();
  *timer.value() =
      value < 0.0 ? Clocks::Timer{timer.value()->at(now), std::nullopt} : Clocks::Timer{value, now};
  return std::nullopt;
}

double date(const Channel& channel, SystemId id) {
  const auto seconds = static_cast<std::int64_t>(channel.port.time_s()) + kNoon;
  switch (static_cast<int>(id)) {
    case static_cast<int>(SystemId::Day):
      return static_cast<double>(kFirstDay + seconds / 86400 % 31);
    case static_cast<int>(SystemId::Month):
      return 1.0;
    case static_cast<int>(SystemId::Year):
      return 0.0;  // 2000
    case static_cast<int>(SystemId::Hour):
      return static_cast<double>(seconds / 3600 % 24);
    case static_cast<int>(SystemId::Minute):
      return static_cast<double>(seconds / 60 % 60);
    default:
      return static_cast<double>(seconds % 60);
  }
}

bool is_of_spindle(SystemId id) {
  return id >= SystemId::SpeedProgrammed && id <= SystemId::SpeedNow;
}

Result<double, Failure> spindle_number_of(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (which != 0 && which != 1) {
    return failure(AlarmId::IndexOne, fmt::format("there is spindle 1, no {}", which));
  }
  const Spindle& spindle = channel.spindle;
  if (access.id == SystemId::SpeedProgrammed) {
    return cuts_at_constant_speed(channel.group[15]) ? spindle.cutting_speed : spindle.speed;
  }
  if (access.id != SystemId::SpeedNow) {
    return static_cast<double>(spindle.direction);
  }
  const bool turns = spindle.direction > 0 && spindle.direction < kStill;
  const double speed = turns ? spindle_speed(channel, channel.present()[kTransverseAxis]) : 0.0;
  return spindle.direction == kCounterclockwise ? -speed : speed;
}

}  // namespace g31::sinumerik

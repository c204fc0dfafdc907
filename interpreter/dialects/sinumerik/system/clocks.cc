#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

/// The simulated clock starts at noon of this day.
constexpr int kFirstDay = 1;
constexpr int kNoon = 12 * 3600;
constexpr double kSecondsPerMinute = 60.0;

std::int64_t seconds(const Channel& channel) {
  return static_cast<std::int64_t>(channel.port.time_s()) + kNoon;
}

Result<Clocks::Timer*, Failure> timer_of(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (which < 0 || which >= Clocks::kTimers) {
    return failure(AlarmId::IndexOne, fmt::format("$AC_TIMER[{}]", which));
  }
  return &channel.clocks.timers[static_cast<std::size_t>(which)];
}

// What counters show as long as no program has set them.
double running(const Channel& channel) {
  return channel.port.time_s();
}
double cutting(const Channel& channel) {
  return channel.outlet.cutting_s();
}
double minutes(const Channel& channel) {
  return channel.port.time_s() / kSecondsPerMinute;
}

/// A counter that programs may set: what it counts, and what was written, less that.
struct Counter {
  double (*counted)(const Channel&);
  double Clocks::*offset;
};
constexpr Counter kOperating = {running, &Clocks::operating_offset};
constexpr Counter kCycle = {running, &Clocks::cycle_offset};
constexpr Counter kCutting = {cutting, &Clocks::cutting_offset};
constexpr Counter kSetup = {minutes, &Clocks::setup_offset};
constexpr Counter kPowerOn = {minutes, &Clocks::power_on_offset};

Number shown(Channel& channel, const Counter& counter) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  return counter.counted(channel) + channel.clocks.*counter.offset;
}

MaybeFailure set(Channel& channel, const Counter& counter, double value) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  channel.clocks.*counter.offset = value - counter.counted(channel);
  return std::nullopt;
}

}  // namespace

Number day(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(kFirstDay + seconds(channel) / 86400 % 31);
}

Number month(Channel& /*channel*/, const SystemAccess& /*access*/) {
  return 1.0;
}

Number year(Channel& /*channel*/, const SystemAccess& /*access*/) {
  return 0.0;  // 2000
}

Number hour(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(seconds(channel) / 3600 % 24);
}

Number minute(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(seconds(channel) / 60 % 60);
}

Number second(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(seconds(channel) % 60);
}

Number block_time(Channel& channel, const SystemAccess& /*access*/) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  if (!channel.clocks.block_began) {
    return failure(AlarmId::NotImplemented, "$AC_TIME, as no program of this run reads it");
  }
  return running(channel) - *channel.clocks.block_began;
}

Number net_time(Channel& channel, const SystemAccess& /*access*/) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  return running(channel);
}

Number timer(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  const auto timer = timer_of(channel, access);
  return timer ? Number(timer.value()->at(channel.port.time_s())) : timer.error();
}

MaybeFailure set_timer(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
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

Number action_override(Channel& channel, const SystemAccess& /*access*/) {
  return channel.action_override_percent;
}

MaybeFailure set_action_override(Channel& channel, const SystemAccess& /*access*/, double value) {
  constexpr double kMost = 200.0;
  if (!(value > 0.0 && value <= kMost)) {
    return failure(
        AlarmId::NotImplemented,
        fmt::format(
            "$AC_OVR={:g}: the path would stop, and nothing within a block would let it continue",
            value));
  }
  channel.action_override_percent = value;
  return std::nullopt;
}

Number operating_time(Channel& channel, const SystemAccess& /*access*/) {
  return shown(channel, kOperating);
}

MaybeFailure set_operating_time(Channel& channel, const SystemAccess& /*access*/, double value) {
  return set(channel, kOperating, value);
}

Number cycle_time(Channel& channel, const SystemAccess& /*access*/) {
  return shown(channel, kCycle);
}

MaybeFailure set_cycle_time(Channel& channel, const SystemAccess& /*access*/, double value) {
  return set(channel, kCycle, value);
}

Number cutting_time(Channel& channel, const SystemAccess& /*access*/) {
  return shown(channel, kCutting);
}

MaybeFailure set_cutting_time(Channel& channel, const SystemAccess& /*access*/, double value) {
  return set(channel, kCutting, value);
}

Number setup_time(Channel& channel, const SystemAccess& /*access*/) {
  return shown(channel, kSetup);
}

MaybeFailure set_setup_time(Channel& channel, const SystemAccess& /*access*/, double value) {
  return set(channel, kSetup, value);
}

Number power_on_time(Channel& channel, const SystemAccess& /*access*/) {
  return shown(channel, kPowerOn);
}

MaybeFailure set_power_on_time(Channel& channel, const SystemAccess& /*access*/, double value) {
  return set(channel, kPowerOn, value);
}

}  // namespace g31::sinumerik::system

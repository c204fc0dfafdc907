#include <numbers>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

constexpr double kCounterclockwise = 4.0;
constexpr double kStill = 5.0;

/// Of which spindle a variable is.
Result<const Spindle*, Failure> spindle_of(const Channel& channel, const SystemAccess& access) {
  static const Spindle kUnused;
  const int which = access.indices[0];
  if (which == 0 || which == channel.master_spindle) {
    return &channel.spindle;
  }
  if (which < 0 || which > kMostSpindles) {
    return failure(AlarmId::IndexOne, fmt::format("spindle {}", which));
  }
  const auto found = channel.other_spindles.find(which);
  return found != channel.other_spindles.end() ? &found->second : &kUnused;
}

MaybeFailure no_probe(const SystemAccess& access) {
  const int which = access.indices[0];
  return which >= 1 && which <= Channel::kMostProbes
             ? std::nullopt
             : MaybeFailure(failure(AlarmId::IndexOne, "probes are numbered 1 to 8"));
}

/// @param of  where the index points: elements that count from 0
template <typename Elements>
MaybeFailure no_element(const SystemAccess& access, const Elements& of, std::string_view name) {
  const int which = access.indices[0];
  return which >= 0 && which < static_cast<int>(of.size())
             ? std::nullopt
             : MaybeFailure(failure(AlarmId::IndexOne, fmt::format("{}[{}]", name, which)));
}

MaybeFailure no_input(const Channel& channel, const SystemAccess& access) {
  return no_element(access, channel.digital_inputs, "$A_IN");
}

MaybeFailure no_analog_input(const Channel& channel, const SystemAccess& access) {
  return no_element(access, channel.analog_inputs, "$A_INA");
}

}  // namespace

Number zero(Channel& /*channel*/, const SystemAccess& /*access*/) {
  return 0.0;
}

Number pi(Channel& /*channel*/, const SystemAccess& /*access*/) {
  return std::numbers::pi;
}

/// Software 4.8: two digits each of version, revision and state.
Number version(Channel& /*channel*/, const SystemAccess& /*access*/) {
  return 480000.0;
}

Number nothing_of_axis(Channel& /*channel*/, const SystemAccess& access) {
  return access.indices[0] < 0 ? Number(failure(AlarmId::BadAxisIndex)) : 0.0;
}

/// Of a program or channel that runs.
Number active(Channel& /*channel*/, const SystemAccess& /*access*/) {
  return 2.0;
}

Number status_of_axis(Channel& /*channel*/, const SystemAccess& access) {
  constexpr double kStopsFine = 4.0;
  return access.indices[0] < 0 ? Number(failure(AlarmId::BadAxisIndex)) : kStopsFine;
}

Number motion_end(Channel& channel, const SystemAccess& access) {
  const int axis = access.indices[0];
  return axis < 0 ? Number(failure(AlarmId::BadAxisIndex))
                  : static_cast<double>(
                        channel.axis_settings.motion_end[static_cast<std::size_t>(axis)]);
}

/// No magazines and no multitools are simulated.
Number kind_of_number(Channel& channel, const SystemAccess& access) {
  constexpr double kTool = 1.0;
  constexpr double kNothing = -3.0;
  return channel.find_tool(access.indices[0]) != nullptr ? kTool : kNothing;
}

Number tool_number(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.tool);
}

Number edge_number(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.edge);
}

Number additive_number(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.additive);
}

Number tool_count(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.tools.size());
}

Number channel_number(Channel& /*channel*/, const SystemAccess& /*access*/) {
  return 1.0;
}

Number feed(Channel& channel, const SystemAccess& /*access*/) {
  return channel.feed.kept() / programmed(channel, 1.0).kept();
}

Number first_axis(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.plane().first);
}

Number second_axis(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.plane().second);
}

Number third_axis(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.plane().normal);
}

Number geometry_axis(Channel& /*channel*/, const SystemAccess& access) {
  const int which = access.indices[0];
  return which < 1 || which > 3
             ? Number(failure(AlarmId::IndexOne, fmt::format("$P_ACTGEOAX[{}]", which)))
             : static_cast<double>(which - 1);
}

Number settable_number(Channel& channel, const SystemAccess& /*access*/) {
  return static_cast<double>(channel.settable_number());
}

Number dry_run(Channel& channel, const SystemAccess& /*access*/) {
  return channel.feed_switches.dry_run_mm_min > 0.0 ? 1.0 : 0.0;
}

Number modal_code(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (which < 1 || which >= kGroupCount) {
    return failure(AlarmId::IndexOne, fmt::format("$P_GG[{}]", which));
  }
  return static_cast<double>(channel.group.at(static_cast<std::size_t>(which)));
}

Number master_spindle(Channel& channel, const SystemAccess& /*access*/) {
  return channel.master_spindle;
}

Number speed_programmed(Channel& channel, const SystemAccess& access) {
  const auto spindle = spindle_of(channel, access);
  if (!spindle) {
    return spindle.error();
  }
  const bool at_constant_speed =
      spindle.value() == &channel.spindle && cuts_at_constant_speed(channel.group[Group::FeedType]);
  return at_constant_speed ? spindle.value()->cutting_speed / metres_of_cutting(channel)
                           : spindle.value()->speed;
}

Number spindle_turn(Channel& channel, const SystemAccess& access) {
  const auto spindle = spindle_of(channel, access);
  return spindle ? Number(static_cast<double>(spindle.value()->direction)) : spindle.error();
}

Number spindle_mode(Channel& channel, const SystemAccess& access) {
  const auto spindle = spindle_of(channel, access);
  if (!spindle) {
    return spindle.error();
  }
  const int turn = spindle.value()->direction;
  return turn == Spindle::kNothingYet ? 0.0 : turn == Spindle::kPositioned ? 2.0 : 1.0;
}

Number speed_now(Channel& channel, const SystemAccess& access) {
  const auto found = spindle_of(channel, access);
  if (!found) {
    return found.error();
  }
  const Spindle& spindle = *found.value();
  const bool turns = spindle.direction > 0 && spindle.direction < kStill;
  const double speed = !turns ? 0.0
                       : &spindle == &channel.spindle
                           ? spindle_speed(channel, channel.present()[kTransverseAxis])
                           : spindle.turning_speed();
  return spindle.direction == kCounterclockwise ? -speed : speed;
}

Number probe_signal(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = no_probe(access)) {
    return *wrong;
  }
  channel.touches.looks_at_signal(access.indices[0]);
  return channel.port.skip_signal(access.indices[0]) ? 1.0 : 0.0;
}

Number probe_switched(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = no_probe(access)) {
    return *wrong;
  }
  channel.touches.asks(access.indices[0]);
  return channel.measured[static_cast<std::size_t>(access.indices[0])] ? 1.0 : 0.0;
}

/// As the probe is wired to it, else as the set-up sheet scripts it, else as that or the program
/// has it.  A program may wait for either, so that looks take time.
Number digital_input(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = no_input(channel, access)) {
    return *wrong;
  }
  channel.touches.looks_at_input();
  const int which = access.indices[0];
  const bool kept = channel.digital_inputs[static_cast<std::size_t>(which)];
  if (!channel.is_inspected()) {
    channel.outlet.stop_cutting();
    channel.busy_wait.look(channel.port);
  }
  const auto scripted = channel.is_inspected() ? channel.inputs.shown(which)
                                               : channel.inputs.look(which, channel.now());
  return channel.port.digital_input(which).value_or(scripted.value_or(kept)) ? 1.0 : 0.0;
}

/// A sensor is read where the axes have come to rest.
Number analog_input(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = no_analog_input(channel, access)) {
    return *wrong;
  }
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  const int which = access.indices[0];
  return channel.port.displacement(which).value_or(
      channel.analog_inputs[static_cast<std::size_t>(which)]);
}

MaybeFailure set_analog_input(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = no_analog_input(channel, access)) {
    return wrong;
  }
  channel.analog_inputs[static_cast<std::size_t>(access.indices[0])] = value;
  return std::nullopt;
}

Number digital_output(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = no_input(channel, access)) {
    return *wrong;
  }
  return channel.digital_outputs[static_cast<std::size_t>(access.indices[0])] ? 1.0 : 0.0;
}

MaybeFailure set_digital_output(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = no_input(channel, access)) {
    return wrong;
  }
  channel.digital_outputs[static_cast<std::size_t>(access.indices[0])] = value != 0.0;
  channel.port.digital_output({access.indices[0], value != 0.0});
  return std::nullopt;
}

MaybeFailure set_digital_input(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = no_input(channel, access)) {
    return wrong;
  }
  channel.digital_inputs[static_cast<std::size_t>(access.indices[0])] = value != 0.0;
  return std::nullopt;
}

}  // namespace g31::sinumerik::system

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik {
namespace {

Result<double, Failure> axis_value(const Channel& channel, const SystemAccess& access,
                                   const AxisPositions& q) {
  const int axis = access.indices[0];
  if (axis < 0) {
    return failure(AlarmId::BadAxisIndex);
  }
  return channel.shown(axis, q[axis]);
}

/// In work coordinates, where DIAMON counts.
Result<double, Failure> place_value(const Channel& channel, const SystemAccess& access,
                                    const AxisPositions& q_W) {
  const int axis = access.indices[0];
  if (axis < 0) {
    return failure(AlarmId::BadAxisIndex);
  }
  return channel.shown_place(axis, q_W[axis]);
}

/// The present position within some of the frames.
AxisPositions within(const Channel& channel, const Frame& frame) {
  return frame.undo(channel.port.position() - channel.tool_offset());
}

/// $AA_..[axis], $P_EP[axis]
Result<double, Failure> position(Channel& channel, const SystemAccess& access) {
  const bool is_now = access.id >= SystemId::MachineNow && access.id <= SystemId::SettableNow;
  if (MaybeFailure wrong = is_now ? finish_motion(channel) : std::nullopt) {
    return *wrong;
  }
  switch (static_cast<int>(access.id)) {
    case static_cast<int>(SystemId::BlockEnd):
      return place_value(channel, access, channel.programmed());
    case static_cast<int>(SystemId::MachineNow):
    case static_cast<int>(SystemId::BasicNow):
      return axis_value(channel, access, channel.port.position());
    case static_cast<int>(SystemId::BasicZeroNow):
      return place_value(channel, access, within(channel, channel.set_frame.chained(channel.base)));
    case static_cast<int>(SystemId::SettableNow):
      return place_value(channel, access, within(channel, channel.frames_below()));
    case static_cast<int>(SystemId::WorkNow):
      return place_value(channel, access, channel.to_work(channel.port.position()));
    case static_cast<int>(SystemId::MachineMeasured):
    case static_cast<int>(SystemId::MachineTrigger):
      return axis_value(channel, access, channel.q_M_measured);
    default:
      return place_value(channel, access, channel.q_W_measured);
  }
}

/// A point of the machine's builder; nullptr: there is none of this number, or no such axis.
double* machine_point(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  const int axis = access.indices[1];
  const int count = access.id == SystemId::FixedPoint ? MachinePoints::kFixedPoints : 1;
  if (which < 0 || which >= count || axis < 0) {
    return nullptr;
  }
  AxisPositions& q_M = access.id == SystemId::FixedPoint
                           ? channel.points.q_M_fixed[static_cast<std::size_t>(which)]
                           : channel.points.q_M_reference;
  return &q_M[axis];
}

Failure no_point(const SystemAccess& access) {
  return access.indices[1] < 0
             ? failure(AlarmId::BadAxisIndex)
             : failure(AlarmId::IndexOne, fmt::format("point {}", access.indices[0]));
}

Result<double, Failure> point_value(Channel& channel, const SystemAccess& access) {
  const double* const place = machine_point(channel, access);
  if (place == nullptr) {
    return no_point(access);
  }
  return channel.shown(access.indices[1], *place);
}

Result<double, Failure> indexed_state(const Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (access.id == SystemId::ModalCode) {
    if (which < 1 || which >= kGroupCount) {
      return failure(AlarmId::IndexOne, fmt::format("$P_GG[{}]", which));
    }
    return static_cast<double>(channel.group[static_cast<std::size_t>(which)]);
  }
  if (access.id == SystemId::GeometryAxis) {
    return which < 1 || which > 3 ? Result<double, Failure>(failure(
                                        AlarmId::IndexOne, fmt::format("$P_ACTGEOAX[{}]", which)))
                                  : static_cast<double>(which - 1);
  }
  if (which < 1 || which > Channel::kMostProbes) {
    return failure(AlarmId::IndexOne, "there are the probes 1 to 8");
  }
  if (access.id == SystemId::ProbeSignal) {
    return channel.port.skip_signal(which) ? 1.0 : 0.0;
  }
  return channel.measured[static_cast<std::size_t>(which)] ? 1.0 : 0.0;
}

Failure no_input(int number) {
  return failure(AlarmId::IndexOne, fmt::format("$A_IN[{}]", number));
}

bool is_input(const Channel& channel, int number) {
  return number >= 0 && number < static_cast<int>(channel.digital_inputs.size());
}

Result<double, Failure> digital_input(const Channel& channel, int number) {
  if (!is_input(channel, number)) {
    return no_input(number);
  }
  const bool kept = channel.digital_inputs[static_cast<std::size_t>(number)];
  return channel.port.digital_input(number).value_or(kept) ? 1.0 : 0.0;
}

Result<double, Failure> plain_state(const Channel& channel, SystemId id) {
  switch (static_cast<int>(id)) {
    case static_cast<int>(SystemId::ToolNumber):
      return static_cast<double>(channel.tool);
    case static_cast<int>(SystemId::EdgeNumber):
      return static_cast<double>(channel.edge);
    case static_cast<int>(SystemId::AdditiveNumber):
      return static_cast<double>(channel.additive);
    case static_cast<int>(SystemId::ToolCount):
      return static_cast<double>(channel.tools.size());
    case static_cast<int>(SystemId::Channel):
      return 1.0;
    case static_cast<int>(SystemId::Feed):
      return channel.feed;
    case static_cast<int>(SystemId::FirstAxis):
      return static_cast<double>(channel.plane().first);
    case static_cast<int>(SystemId::SecondAxis):
      return static_cast<double>(channel.plane().second);
    case static_cast<int>(SystemId::ThirdAxis):
      return static_cast<double>(channel.plane().normal);
    case static_cast<int>(SystemId::MasterSpindle):
      return channel.master_spindle;
    case static_cast<int>(SystemId::SettableNumber):
      return static_cast<double>(channel.settable_number());
    case static_cast<int>(SystemId::InDryRun):
      return channel.feed_switches.dry_run_mm_min > 0.0 ? 1.0 : 0.0;
    case static_cast<int>(SystemId::InTest):
    case static_cast<int>(SystemId::InSearch):
    case static_cast<int>(SystemId::InSimulation):
    case static_cast<int>(SystemId::InLog):
      return 0.0;
    default:
      return date(channel, id);
  }
}

}  // namespace

Result<double, Failure> number_of(Channel& channel, const SystemAccess& access) {
  switch (static_cast<int>(access.id)) {
    case static_cast<int>(SystemId::BlockEnd):
    case static_cast<int>(SystemId::MachineNow):
    case static_cast<int>(SystemId::WorkNow):
    case static_cast<int>(SystemId::BasicNow):
    case static_cast<int>(SystemId::BasicZeroNow):
    case static_cast<int>(SystemId::SettableNow):
    case static_cast<int>(SystemId::MachineMeasured):
    case static_cast<int>(SystemId::WorkMeasured):
    case static_cast<int>(SystemId::MachineTrigger):
    case static_cast<int>(SystemId::WorkTrigger):
      return position(channel, access);
    case static_cast<int>(SystemId::AxisMeasures):
      return access.indices[0] < 0 ? Result<double, Failure>(failure(AlarmId::BadAxisIndex)) : 0.0;
    case static_cast<int>(SystemId::ReferencePoint):
    case static_cast<int>(SystemId::FixedPoint):
      return point_value(channel, access);
    case static_cast<int>(SystemId::DigitalInput):
      return digital_input(channel, access.indices[0]);
    case static_cast<int>(SystemId::ModalCode):
    case static_cast<int>(SystemId::Measured):
    case static_cast<int>(SystemId::ProbeSignal):
    case static_cast<int>(SystemId::GeometryAxis):
      return indexed_state(channel, access);
    default:
      break;
  }
  if (is_of_tools(access.id)) {
    return tool_number_of(channel, access);
  }
  if (is_time(access.id)) {
    return time_of(channel, access);
  }
  return is_of_spindle(access.id) ? spindle_number_of(channel, access)
                                  : plain_state(channel, access.id);
}

MaybeFailure set_number(Channel& channel, SystemAccess access, double value) {
  if (access.indices.size() >= 2 && access.id >= SystemId::SettableFrames &&
      access.id <= SystemId::ActiveFrame) {
    SystemAccess frame_access = access;
    const auto frame = frame_of(channel, frame_access);
    if (!frame) {
      return frame.error();
    }
    Frame changed = frame.value();
    const Component component = *frame_access.component;
    changed.set_component(frame_access.axis, component,
                          channel.stored_component(frame_access.axis, component, value));
    return set_frame(channel, frame_access, changed);
  }
  if (access.id == SystemId::DigitalInput) {
    if (!is_input(channel, access.indices[0])) {
      return no_input(access.indices[0]);
    }
    channel.digital_inputs[static_cast<std::size_t>(access.indices[0])] = value != 0.0;
    return std::nullopt;
  }
  if (access.id == SystemId::ReferencePoint || access.id == SystemId::FixedPoint) {
    double* const place = machine_point(channel, access);
    if (place == nullptr) {
      return no_point(access);
    }
    *place = channel.stored(access.indices[1], value);
    return std::nullopt;
  }
  return is_time(access.id) ? set_time(channel, access, value)
                            : set_tool_number(channel, std::move(access), value);
}

}  // namespace g31::sinumerik

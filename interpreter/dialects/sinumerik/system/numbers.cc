#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik {
namespace {

/// The simulated clock starts at noon of this day.
constexpr int kFirstDay = 1;
constexpr int kNoon = 12 * 3600;

Failure no_edge(const SystemAccess& access) {
  return failure(AlarmId::NoToolEdge,
                 fmt::format("T{}, D{}", access.indices[0], access.indices[1]));
}

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

/// $AA_..[axis], $P_EP[axis]
Result<double, Failure> position(Channel& channel, const SystemAccess& access) {
  const bool is_now = access.id == SystemId::MachineNow || access.id == SystemId::WorkNow;
  if (MaybeFailure wrong = is_now ? finish_motion(channel) : std::nullopt) {
    return *wrong;
  }
  switch (static_cast<int>(access.id)) {
    case static_cast<int>(SystemId::BlockEnd):
      return place_value(channel, access, channel.programmed());
    case static_cast<int>(SystemId::MachineNow):
      return axis_value(channel, access, channel.port.position());
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

/// Of the active edge.
Result<double, Failure> active_edge_value(const Channel& channel, const SystemAccess& access) {
  const EdgeData* const edge = channel.active_edge();
  if (access.id == SystemId::ToolRadius) {
    return channel.tool_radius();
  }
  const int which = access.indices[0];
  if (access.id == SystemId::ToolLength) {
    if (which < 1 || which > 3) {
      return failure(AlarmId::IndexOne, fmt::format("$P_TOOLL[{}]", which));
    }
    const Plane plane = channel.plane();
    const int axes[] = {plane.normal, plane.second, plane.first};
    return channel.tool_offset()[axes[which - 1]];
  }
  if (which < 1 || which >= static_cast<int>(EdgeData().size())) {
    return failure(AlarmId::IndexOne, fmt::format("$P_AD[{}]", which));
  }
  return edge != nullptr ? (*edge)[static_cast<std::size_t>(which)] : 0.0;
}

/// $TC_..
Result<double, Failure> tool_value(Channel& channel, const SystemAccess& access) {
  if (access.id == SystemId::ToolDuplo || access.id == SystemId::ToolState) {
    const Tool* const tool = channel.find_tool(access.indices[0]);
    if (tool == nullptr) {
      return failure(AlarmId::BadTNumber, fmt::format("T{}", access.indices[0]));
    }
    return access.id == SystemId::ToolDuplo ? tool->duplo : tool->state;
  }
  EdgeData* const edge = channel.find_edge(access.indices[0], access.indices[1]);
  if (edge == nullptr) {
    return no_edge(access);
  }
  if (access.id == SystemId::EdgeTeeth) {
    return channel.find_tool(access.indices[0])->teeth[access.indices[1]];
  }
  return (*edge)[static_cast<std::size_t>(access.parameter)];
}

double clock(const Channel& channel, SystemId id) {
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

Result<double, Failure> indexed_state(const Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (access.id == SystemId::ModalCode) {
    if (which < 1 || which >= kGroupCount) {
      return failure(AlarmId::IndexOne, fmt::format("$P_GG[{}]", which));
    }
    return static_cast<double>(channel.group[static_cast<std::size_t>(which)]);
  }
  if (which < 1 || which > Channel::kMostProbes) {
    return failure(AlarmId::IndexOne, "there are the probes 1 to 8");
  }
  if (access.id == SystemId::ProbeSignal) {
    return channel.port.skip_signal(which) ? 1.0 : 0.0;
  }
  return channel.measured[static_cast<std::size_t>(which)] ? 1.0 : 0.0;
}

Result<double, Failure> plain_state(const Channel& channel, SystemId id) {
  switch (static_cast<int>(id)) {
    case static_cast<int>(SystemId::ToolNumber):
      return static_cast<double>(channel.tool);
    case static_cast<int>(SystemId::EdgeNumber):
      return static_cast<double>(channel.edge);
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
      return clock(channel, id);
  }
}

}  // namespace

Result<double, Failure> number_of(Channel& channel, const SystemAccess& access) {
  switch (static_cast<int>(access.id)) {
    case static_cast<int>(SystemId::BlockEnd):
    case static_cast<int>(SystemId::MachineNow):
    case static_cast<int>(SystemId::WorkNow):
    case static_cast<int>(SystemId::MachineMeasured):
    case static_cast<int>(SystemId::WorkMeasured):
    case static_cast<int>(SystemId::MachineTrigger):
    case static_cast<int>(SystemId::WorkTrigger):
      return position(channel, access);
    case static_cast<int>(SystemId::ToolRadius):
    case static_cast<int>(SystemId::ToolLength):
    case static_cast<int>(SystemId::ActiveEdgeData):
      return active_edge_value(channel, access);
    case static_cast<int>(SystemId::EdgeParameter):
    case static_cast<int>(SystemId::EdgeTeeth):
    case static_cast<int>(SystemId::ToolDuplo):
    case static_cast<int>(SystemId::ToolState):
      return tool_value(channel, access);
    case static_cast<int>(SystemId::ReferencePoint):
    case static_cast<int>(SystemId::FixedPoint):
      return point_value(channel, access);
    case static_cast<int>(SystemId::ModalCode):
    case static_cast<int>(SystemId::Measured):
    case static_cast<int>(SystemId::ProbeSignal):
      return indexed_state(channel, access);
    default:
      return plain_state(channel, access.id);
  }
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
  if (access.id == SystemId::ReferencePoint || access.id == SystemId::FixedPoint) {
    double* const place = machine_point(channel, access);
    if (place == nullptr) {
      return no_point(access);
    }
    *place = channel.stored(access.indices[1], value);
    return std::nullopt;
  }
  if (access.id == SystemId::ActiveEdgeData) {
    access.parameter = access.indices[0];
    access.indices = {channel.tool, channel.edge};
    access.id = SystemId::EdgeParameter;
    if (access.parameter < 1 || access.parameter >= static_cast<int>(EdgeData().size())) {
      return failure(AlarmId::IndexOne, fmt::format("$P_AD[{}]", access.parameter));
    }
    if (channel.edge_now) {
      (*channel.edge_now)[static_cast<std::size_t>(access.parameter)] = value;
      channel.frames_changed();
    }
  }
  Tool* const tool = channel.tool_to_write(access.indices[0]);
  if (tool == nullptr) {
    return failure(AlarmId::BadTNumber, fmt::format("T{}", access.indices[0]));
  }
  if (access.id == SystemId::EdgeParameter) {
    // Writing to an edge that is not there makes it.
    tool->edges[access.indices[1]][static_cast<std::size_t>(access.parameter)] = value;
  } else if (access.id == SystemId::EdgeTeeth) {
    tool->teeth[access.indices[1]] = value;
  } else {
    (access.id == SystemId::ToolDuplo ? tool->duplo : tool->state) = value;
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

/// Where an axis stands that carries neither tool nor part, within some of the frames.
Number further_place(const Channel& channel, int axis, const Frame& frame) {
  if (!is_further_axis(axis)) {
    return failure(AlarmId::BadAxisIndex);
  }
  const FurtherAxis* const further = channel.further(axis);
  return further != nullptr ? Number(frame.undo(axis, further->at) / channel.mm_per_datum())
                            : Number(no_such_axis(axis));
}

Number axis_value(const Channel& channel, const SystemAccess& access, const AxisPositions& q) {
  const int axis = access.indices[0];
  if (!is_machine_axis(axis)) {
    return further_place(channel, axis, Frame());
  }
  return channel.within_turn(axis, channel.shown_datum(axis, q[axis]));
}

/// In coordinates within some of the frames, where DIAMON counts.
Number place_value(const Channel& channel, const SystemAccess& access, const AxisPositions& q_W,
                   const Frame& frame) {
  const int axis = access.indices[0];
  if (!is_machine_axis(axis)) {
    return further_place(channel, axis, frame);
  }
  return channel.within_turn(axis, channel.shown_place(axis, q_W[axis]));
}

/// What the last measuring move latched goes into an expression.
void measured_read(Channel& channel) {
  if (!channel.touches.result_read(channel.diagnostics)) {
    channel.warnings.add(channel.diagnostics, source::DiagnosticId::NothingMeasured, channel.here(),
                         "the result of MEAS");
  }
}

/// The present position within some of the frames.
AxisPositions within(const Channel& channel, const Frame& frame) {
  return frame.undo(channel.to_basic(channel.port.position()));
}

/// A point of the machine's builder; its first index is below `count`, its second one an axis.
Result<double*, Failure> machine_point(std::span<AxisPositions> points,
                                       const SystemAccess& access) {
  const int which = access.indices[0];
  const int axis = access.indices[1];
  if (!is_machine_axis(axis)) {
    return failure(AlarmId::BadAxisIndex);
  }
  if (which < 0 || which >= static_cast<int>(points.size())) {
    return failure(AlarmId::IndexOne, fmt::format("point {}", which));
  }
  return &points[static_cast<std::size_t>(which)][axis];
}

Number point_value(const Channel& channel, std::span<AxisPositions> points,
                   const SystemAccess& access) {
  const auto place = machine_point(points, access);
  return place ? Number(channel.shown_datum(access.indices[1], *place.value())) : place.error();
}

MaybeFailure set_point(const Channel& channel, std::span<AxisPositions> points,
                       const SystemAccess& access, double value) {
  const auto place = machine_point(points, access);
  if (!place) {
    return place.error();
  }
  *place.value() = channel.stored_datum(access.indices[1], value);
  return std::nullopt;
}

std::span<AxisPositions> reference_points(Channel& channel) {
  return {&channel.points.q_M_reference, 1};
}

}  // namespace

Number block_end(Channel& channel, const SystemAccess& access) {
  return place_value(channel, access, channel.programmed(), channel.active_frame());
}

Number machine_now(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  channel.touches.looks();
  return axis_value(channel, access, channel.port.position());
}

Number work_now(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  channel.touches.looks();
  return place_value(channel, access, channel.to_work(channel.port.position()),
                     channel.active_frame());
}

Number basic_zero_now(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  return place_value(channel, access, within(channel, channel.frames_outside()),
                     channel.frames_outside());
}

Number settable_now(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  return place_value(channel, access, within(channel, channel.frames_below()),
                     channel.frames_below());
}

Number machine_measured(Channel& channel, const SystemAccess& access) {
  measured_read(channel);
  return axis_value(channel, access, channel.q_M_measured);
}

Number work_measured(Channel& channel, const SystemAccess& access) {
  measured_read(channel);
  return place_value(channel, access, channel.q_W_measured, channel.active_frame());
}

Number machine_measured_second(Channel& channel, const SystemAccess& access) {
  measured_read(channel);
  return axis_value(channel, access, channel.q_M_second);
}

Number work_measured_second(Channel& channel, const SystemAccess& access) {
  measured_read(channel);
  return place_value(channel, access, channel.q_W_second, channel.active_frame());
}

Number upper_soft_limit(Channel& channel, const SystemAccess& access) {
  return axis_value(channel, access, channel.upper_soft_limits());
}

Number lower_soft_limit(Channel& channel, const SystemAccess& access) {
  return axis_value(channel, access, channel.lower_soft_limits());
}

Number reference_point(Channel& channel, const SystemAccess& access) {
  return point_value(channel, reference_points(channel), access);
}

MaybeFailure set_reference_point(Channel& channel, const SystemAccess& access, double value) {
  return set_point(channel, reference_points(channel), access, value);
}

Number fixed_point(Channel& channel, const SystemAccess& access) {
  return point_value(channel, channel.points.q_M_fixed, access);
}

MaybeFailure set_fixed_point(Channel& channel, const SystemAccess& access, double value) {
  return set_point(channel, channel.points.q_M_fixed, access, value);
}

}  // namespace g31::sinumerik::system

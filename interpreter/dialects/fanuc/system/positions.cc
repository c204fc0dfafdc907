#include "interpreter/dialects/fanuc/system/access.h"

namespace g31::fanuc::system {
namespace {

/// What a variable shows of a coordinate.
using View = double (Control::*)(int axis, double value) const;

ReadResult axis_of(Control& control, const Place& place, const AxisPositions& q, View view) {
  control.position_read();
  const auto axis = control.controlled_axis(place.index());
  return axis ? ReadResult(Cell((control.*view)(*axis, q[*axis]))) : AlarmId::IllegalVariable;
}

/// A rotary axis that goes round is shown within its turn.
ReadResult coordinate_of(Control& control, const Place& place, AxisPositions q, View view) {
  for (int axis = kLinearAxisCount; axis < static_cast<int>(kAxisCount); ++axis) {
    q[axis] = control.roll_over.shown(axis, q[axis]);
  }
  return axis_of(control, place, q, view);
}

}  // namespace

ReadResult read_block_end(Control& control, const Place& place) {
  return coordinate_of(control, place, control.coordinates.programmed(), &Control::counted);
}

ReadResult read_machine_position(Control& control, const Place& place) {
  return coordinate_of(control, place, control.position(), &Control::counted);
}

ReadResult read_work_position(Control& control, const Place& place) {
  return coordinate_of(control, place, control.coordinates.to_work(control.position()),
                       &Control::counted);
}

ReadResult read_skip_position(Control& control, const Place& place) {
  if (!control.touches.result_read(control.diagnostics)) {
    control.warn_once(source::DiagnosticId::NothingMeasured, control.here(), "#5061..");
  }
  return coordinate_of(control, place, control.q_W_skip, &Control::shown);
}

ReadResult read_tool_offset(Control& control, const Place& place) {
  return axis_of(control, place, control.coordinates.tool_offset_at(control.position()),
                 &Control::counted);
}

/// Servo deviation, handle interrupt and distance to go: an ideal control between two blocks.
ReadResult read_nothing_left(Control& control, const Place& place) {
  return axis_of(control, place, AxisPositions::Zero(), &Control::shown);
}

}  // namespace g31::fanuc::system

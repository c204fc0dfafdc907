#include "interpreter/dialects/fanuc/system/access.h"

namespace g31::fanuc::system {
namespace {

ReadResult axis_of(Control& control, const Place& place, const AxisPositions& q) {
  control.position_read();
  const auto axis = control.controlled_axis(place.index());
  return axis ? ReadResult(Cell(control.shown(*axis, q[*axis]))) : AlarmId::IllegalVariable;
}

/// A rotary axis that goes round is shown within its turn.
ReadResult coordinate_of(Control& control, const Place& place, AxisPositions q) {
  for (int axis = kLinearAxisCount; axis < static_cast<int>(kAxisCount); ++axis) {
    q[axis] = control.roll_over.shown(axis, q[axis]);
  }
  return axis_of(control, place, q);
}

}  // namespace

ReadResult read_block_end(Control& control, const Place& place) {
  return coordinate_of(control, place, control.coordinates.programmed());
}

ReadResult read_machine_position(Control& control, const Place& place) {
  return coordinate_of(control, place, control.position());
}

ReadResult read_work_position(Control& control, const Place& place) {
  return coordinate_of(control, place, control.coordinates.to_work(control.position()));
}

ReadResult read_skip_position(Control& control, const Place& place) {
  if (!control.touches.result_read(control.diagnostics)) {
    control.warn_once(source::DiagnosticId::NothingMeasured, control.here(), "#5061..");
  }
  return coordinate_of(control, place, control.q_W_skip);
}

ReadResult read_tool_offset(Control& control, const Place& place) {
  return axis_of(control, place, control.coordinates.tool_offset_at(control.position()));
}

/// Servo deviation, handle interrupt and distance to go: an ideal control between two blocks.
ReadResult read_nothing_left(Control& control, const Place& place) {
  return axis_of(control, place, AxisPositions::Zero());
}

}  // namespace g31::fanuc::system

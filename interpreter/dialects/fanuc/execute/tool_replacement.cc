#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

MaybeFailure lift(Control& control) {
  AxisPositions q_M = control.port.position();
  q_M[kToolAxis] = control.parameters.get_for_axis(ParameterId::ReferencePoint, 0, kToolAxis);
  auto failure =
      rapid_to(control, control.coordinates.path_at(q_M), machine::RapidPath::Independent);
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

MaybeFailure go_to(Control& control, const AxisPositions& q_L_end) {
  if (q_L_end == control.coordinates.programmed()) {
    return std::nullopt;
  }
  auto failure = rapid_to(control, control.coordinates.to_path(q_L_end), control.rapid_path());
  control.coordinates.arrived_at_programmed(q_L_end);
  return failure;
}

}  // namespace

/// G100 and M06 of a Brother: Z goes up, the tool comes, then the axes go to the block's end, Z
/// last.  On the machine they are on their way while the tool changes: the ways are the same.  The
/// height of the change is not in the parts of the manual that could be read: Z goes to its first
/// reference point.
MaybeFailure execute_tool_replacement(Control& control, const NcBlock& block) {
  if (auto failure = lift(control)) {
    return failure;
  }
  change_tool(control);
  const AxisPositions q_L_end = programmed_end(control, block);
  AxisPositions q_L_above = q_L_end;
  q_L_above[kToolAxis] = control.coordinates.programmed()[kToolAxis];
  if (auto failure = go_to(control, q_L_above)) {
    return failure;
  }
  return go_to(control, q_L_end);
}

}  // namespace g31::fanuc

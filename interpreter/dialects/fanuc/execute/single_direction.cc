// G60.  Sources: FANUC operator's manual B-63534EN, single direction positioning (no overrun in an
// axis that does not move, none in the drilling axis of a cycle or where the parameter is 0, and
// the direction is that of the machine under mirror image); M700V programming manual,
// unidirectional positioning; Haas mill operator's manual 96-8000, G60 and setting 35.

#include <cmath>

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

constexpr std::int32_t kFirstSetting = 20000;

/// mm or deg: the last way of an axis, positive towards the positive side.
double last_way(const Control& control, int axis) {
  const SingleDirectionRule& rule = control.profile.single_direction;
  if (rule.setting == 0) {
    return control.parameters.get_for_axis(rule.way, 0, axis);
  }
  const auto found = control.data.find(kFirstSetting + rule.setting);
  return found != control.data.end() ? -std::abs(control.stored(axis, found->second)) : 0.0;
}

}  // namespace

MaybeFailure position_to(Control& control, const AxisPositions& q_B_end) {
  constexpr double kStands = 1e-9;
  const machine::RapidPath path = control.rapid_path();
  if (!control.positions_in_one_direction()) {
    return rapid_to(control, q_B_end, path);
  }
  const AxisPositions q_B = control.path_position();
  AxisPositions q_B_before = q_B_end;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const bool moves = std::abs(q_B_end[axis] - q_B[axis]) > kStands;
    q_B_before[axis] -= moves ? last_way(control, axis) : 0.0;
  }
  if (q_B_before != q_B_end) {
    if (auto failure = rapid_to(control, q_B_before, path)) {
      return failure;
    }
  }
  return rapid_to(control, q_B_end, path);
}

}  // namespace g31::fanuc

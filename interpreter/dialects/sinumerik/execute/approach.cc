#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

/// The named axes at rapid to a place of the machine; what their words say does not count.
MaybeFailure approach(Channel& channel, const Block& block, const AxisPositions& q_M_point) {
  if (MaybeFailure wrong = leave_compensation(channel)) {
    return wrong;
  }
  path::PathBlock move;
  AxisPositions q_M_end = channel.port.position();
  move.g = 0;
  move.where = block.where;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    if (block.words.axis(axis).present) {
      q_M_end[axis] = q_M_point[axis];
    }
  }
  move.q_M_end = channel.machine_to_path(q_M_end);
  if (MaybeFailure wrong = compensate_axes(channel)) {
    return wrong;
  }
  MaybeFailure wrong = travel(channel, move);
  channel.arrived_at_machine();
  return wrong;
}

}  // namespace

MaybeFailure approach_reference(Channel& channel, const Block& block) {
  return approach(channel, block, channel.points.q_M_reference);
}

MaybeFailure approach_fixed_point(Channel& channel, const Block& block) {
  const double number =
      block.words.has(Address::FixedPoint) ? block.words[Address::FixedPoint].value : 1.0;
  if (MaybeFailure wrong = failure(wrong_fixed_point(number))) {
    return wrong;
  }
  return approach(channel, block, channel.points.q_M_fixed[static_cast<std::size_t>(number) - 1]);
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {

AxisPositions programmed_end(const Control& control, const NcBlock& block) {
  AxisPositions q_W_end = control.coordinates.programmed();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const EvaluatedWord* const word = block.words.find(kAxisLetters[axis]);
    if (word == nullptr) {
      continue;
    }
    const double value = axis < 3 ? control.scale.length_mm(*word) : control.scale.angle_deg(*word);
    double& end = q_W_end[static_cast<Eigen::Index>(axis)];
    end = control.modal.incremental() ? end + value : value;
  }
  return q_W_end;
}

Result<double, Failure> feed_in_force(const Control& control) {
  if (control.modal.feed <= 0.0) {
    Failure failure;
    failure.id = AlarmId::NoFeed;
    return failure;
  }
  return control.to_mm(control.modal.feed);
}

MaybeFailure move_to(Control& control, const AxisPositions& q_M_end, machine::Traverse traverse,
                     int g) {
  machine::LinearMove move;
  move.q_M_end = q_M_end;
  move.traverse = traverse;
  if (traverse == machine::Traverse::Feed) {
    const auto feed = feed_in_force(control);
    if (!feed) {
      return feed.error();
    }
    move.feed_mm_min = feed.value();
  }
  return travel(control, move, g);
}

MaybeFailure execute_motion(Control& control, const NcBlock& block) {
  const int g = control.modal.group[1].whole;
  if (g == 2 || g == 3) {
    return execute_arc(control, block);
  }
  const AxisPositions q_W_end = programmed_end(control, block);
  const auto traverse = g == 0 ? machine::Traverse::Rapid : machine::Traverse::Feed;
  if (auto failure = move_to(control, control.coordinates.to_machine(q_W_end), traverse, g)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_W_end);
  return std::nullopt;
}

/// G53: machine coordinates, this block only, absolute; ignored under G91 (MB-291).
MaybeFailure execute_machine_move(Control& control, const NcBlock& block) {
  if (control.modal.incremental()) {
    return std::nullopt;
  }
  AxisPositions q_M_end = control.port.position();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      q_M_end[static_cast<Eigen::Index>(axis)] =
          axis < 3 ? control.scale.length_mm(*word) : control.scale.angle_deg(*word);
    }
  }
  const int g = control.modal.group[1].whole == 1 ? 1 : 0;
  const auto traverse = g == 0 ? machine::Traverse::Rapid : machine::Traverse::Feed;
  auto failure = move_to(control, q_M_end, traverse, g);
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

}  // namespace g31::fanuc

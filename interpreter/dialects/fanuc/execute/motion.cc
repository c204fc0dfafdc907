#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {

namespace {

/// Radius and angle of the block into the polar coordinates; the plane's axes of the end from them.
void take_polar_words(Control& control, const NcBlock& block, AxisPositions& q_L_end) {
  const Plane plane = control.modal.plane();
  PolarCoordinates& polar = *control.polar;
  const bool adds = control.modal.incremental();
  const EvaluatedWord* const radius = block.words.find(kAxisLetters[plane.first]);
  const EvaluatedWord* const angle = block.words.find(kAxisLetters[plane.second]);
  if (radius == nullptr && angle == nullptr) {
    return;
  }
  if (radius != nullptr) {
    const AxisPositions& q_L = control.coordinates.programmed();
    const double value = control.scale.length_mm(*radius);
    adds ? polar.add_radius(value, {q_L[plane.first], q_L[plane.second]}) : polar.set_radius(value);
  }
  if (angle != nullptr) {
    const double value = control.scale.angle_deg(*angle);
    adds ? polar.add_angle(value) : polar.set_angle(value);
  }
  const Eigen::Vector2d p_L = polar.point();
  q_L_end[plane.first] = p_L.x();
  q_L_end[plane.second] = p_L.y();
}

}  // namespace

double axis_value(const Control& control, const EvaluatedWord& word, std::size_t axis) {
  return is_linear_axis(static_cast<int>(axis)) ? control.scale.length_mm(word)
                                                : control.scale.angle_deg(word);
}

AxisPositions cartesian_end(const Control& control, const NcBlock& block) {
  AxisPositions q_L_end = control.coordinates.programmed();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      double& end = q_L_end[static_cast<Eigen::Index>(axis)];
      const double value = axis_value(control, *word, axis);
      end = control.modal.incremental() ? end + value : value;
    }
  }
  return q_L_end;
}

AxisPositions programmed_end(Control& control, const NcBlock& block) {
  AxisPositions q_L_end = cartesian_end(control, block);
  if (control.polar) {
    const AxisPositions& q_L = control.coordinates.programmed();
    const Plane plane = control.modal.plane();
    q_L_end[plane.first] = q_L[plane.first];
    q_L_end[plane.second] = q_L[plane.second];
    take_polar_words(control, block, q_L_end);
  }
  return q_L_end;
}

Result<double, Failure> feed_in_force(const Control& control) {
  if (control.modal.feed <= 0.0) {
    return block_failure(AlarmId::NoFeed);
  }
  const double feed = control.to_mm(control.modal.feed);
  if (control.modal.group[Group::FeedMode].whole != 95) {
    return feed;
  }
  const double revolutions_per_minute = control.modal.words['S' - 'A'];
  if (revolutions_per_minute <= 0.0) {
    return block_failure(AlarmId::NoFeed, "G95 needs a spindle speed S");
  }
  return feed * revolutions_per_minute;
}

double switched_feed(const Control& control, double feed_mm_min) {
  constexpr int kOverrideOff = 1 << 1;  // of #3004
  const auto& modal = control.modal;
  const bool taps = modal.group[Group::CuttingMode].whole == 63 ||
                    modal.group[Group::CannedCycle].whole == 74 ||
                    modal.group[Group::CannedCycle].whole == 84;
  const runtime::FeedSwitches& switches = control.feed_switches;
  if (switches.dry_run_mm_min > 0.0 && !taps) {
    return switches.dry_run_mm_min;
  }
  const bool as_programmed = taps || (control.override_control & kOverrideOff) != 0;
  return as_programmed ? feed_mm_min : feed_mm_min * switches.override_percent / 100.0;
}

MaybeFailure rapid_to(Control& control, const AxisPositions& q_M_end, machine::RapidPath way) {
  path::PathBlock block;
  block.q_M_end = q_M_end;
  block.g = 0;
  block.where = control.block;
  block.rapid_path = way;
  return travel(control, block);
}

MaybeFailure feed_to(Control& control, const AxisPositions& q_M_end, int g) {
  const auto feed = feed_in_force(control);
  if (!feed) {
    return feed.error();
  }
  path::PathBlock block;
  block.q_M_end = q_M_end;
  block.g = g;
  block.where = control.block;
  block.feed_mm_min = switched_feed(control, feed.value());
  block.ends = control.feed_end();
  block.contour_control = control.contour_control();
  block.mm_per_degree = control.scale.mm_per_unit();
  return travel(control, block);
}

MaybeFailure execute_motion(Control& control, const NcBlock& block) {
  const int g = control.modal.group[Group::Motion].whole;
  if (g == 2 || g == 3) {
    return execute_arc(control, block);
  }
  const AxisPositions q_L_end = programmed_end(control, block);
  const AxisPositions q_M_end = control.coordinates.to_machine(q_L_end);
  if (auto failure = g == 0 ? rapid_to(control, q_M_end, control.rapid_path())
                            : feed_to(control, q_M_end, g)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  return std::nullopt;
}

/// G53: machine coordinates, this block only (MB-291).  Under G91 it is ignored, or its values are
/// a distance (M700V programming manual, 14.4 (4)).
MaybeFailure execute_machine_move(Control& control, const NcBlock& block) {
  const bool adds = control.modal.incremental();
  if (adds && !control.profile.machine_moves_add) {
    if (block.has_axis_word) {
      control.warn(source::DiagnosticId::MachineMoveIgnored, block.where);
    }
    return std::nullopt;
  }
  AxisPositions q_M_end = control.port.position();
  const bool cancels = !adds && control.profile.machine_move_length == MachineMoveLength::Cancels;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      const auto place = static_cast<Eigen::Index>(axis);
      const double value = axis_value(control, *word, axis);
      q_M_end[place] = adds ? q_M_end[place] + value : value;
      if (cancels) {
        control.coordinates.end_tool_offset(static_cast<int>(axis));
      }
    }
  }
  auto failure = control.modal.group[Group::Motion].whole == 1
                     ? feed_to(control, q_M_end, 1)
                     : rapid_to(control, q_M_end, control.machine_rapid_path());
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

}  // namespace g31::fanuc

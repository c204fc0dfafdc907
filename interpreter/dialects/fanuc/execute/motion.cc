#include <utility>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/feed.h"

namespace g31::fanuc {

namespace {

/// A tip that moves by rounding alone stands.
constexpr double kTipStandsMm = 1e-9;

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

/// The word of one axis, where the block has it.  Which one is known to the compiler: nothing is
/// looked up for it when it runs.
template <int axis>
void take_axis(const Control& control, const BlockWords& words, bool adds, AxisPositions& q_L_end) {
  constexpr std::size_t kIndex = axis;
  if (const EvaluatedWord* const word = words.find(kAxisLetters[kIndex])) {
    const double value = axis_value(control, *word, kIndex);
    q_L_end = with_one(q_L_end, axis, adds ? q_L_end[axis] + value : value);
  }
}

/// Axis words of the block on the present point (L).
[[gnu::hot]] AxisPositions end_of(const Control& control, const NcBlock& block, bool adds) {
  AxisPositions q_L_end = control.coordinates.programmed();
  [&]<int... axes>(std::integer_sequence<int, axes...>) {
    (take_axis<axes>(control, block.words, adds, q_L_end), ...);
  }
  (std::make_integer_sequence<int, static_cast<int>(kAxisCount)>());
  return q_L_end;
}

/// Absolute words of rotary axes that go round.
void take_roll_over(const Control& control, const NcBlock& block, AxisPositions& q_L_end) {
  const AxisPositions& q_L = control.coordinates.programmed();
  for (int axis = kLinearAxisCount; axis < static_cast<int>(kAxisCount); ++axis) {
    if (block.words.has(kAxisLetters[static_cast<std::size_t>(axis)])) {
      q_L_end[axis] = control.roll_over.end(axis, q_L_end[axis], q_L[axis]);
    }
  }
}

}  // namespace

[[gnu::hot]] AxisPositions cartesian_end(const Control& control, const NcBlock& block) {
  const bool adds = control.modal.incremental();
  AxisPositions q_L_end = end_of(control, block, adds);
  if (!adds && control.roll_over.is_on()) {
    take_roll_over(control, block, q_L_end);
  }
  return q_L_end;
}

AxisPositions named_point(const Control& control, const NcBlock& block) {
  return end_of(control, block, false);
}

[[gnu::hot]] AxisPositions programmed_end(Control& control, const NcBlock& block) {
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

MaybeFailure rapid_to(Control& control, const AxisPositions& q_B_end, machine::RapidPath way) {
  path::PathBlock block;
  block.q_M_end = q_B_end;
  block.g = 0;
  block.where = control.block;
  block.ends = control.rapid_end();
  block.rapid_path = way;
  return travel(control, block);
}

/// The feed is that of the tip at the part; where it stands, that of the rotary axes (parameter
/// 19696.6).
void take_tip_feed(const Control& control, path::PathBlock& block) {
  const double most = control.parameters.get(ParameterId::LargestFeed);
  if (most <= 0.0 || control.parameters.is_on(ParameterId::TurnsByFeed) ||
      control.modal.inverse_time()) {
    return;
  }
  const Point way = linear_axes(block.q_M_end) - linear_axes(control.path_position());
  if (way.norm() < kTipStandsMm) {
    block.feed_mm_min = most;
  }
}

/// @param feed_mm_min  in force
[[gnu::hot]] path::PathBlock feed_block(const Control& control, const AxisPositions& q_B_end, int g,
                                        double feed_mm_min) {
  path::PathBlock block;
  block.q_M_end = q_B_end;
  block.g = g;
  block.where = control.block;
  block.feed_mm_min = switched_feed(control, feed_mm_min);
  block.ends = control.feed_end();
  block.contour_control = control.contour_control();
  block.mm_per_degree = mm_per_degree(control);
  if (control.coordinates.tip_system() != TipSystem::None) {
    take_tip_feed(control, block);
  }
  return block;
}

[[gnu::hot]] MaybeFailure feed_to(Control& control, const AxisPositions& q_B_end, int g) {
  const auto feed = feed_over(control, [&] { return straight_way(control, q_B_end); });
  return feed ? line_to(control, q_B_end, g, feed.value()) : MaybeFailure(feed.error());
}

[[gnu::hot]] MaybeFailure line_to(Control& control, const AxisPositions& q_B_end, int g,
                                  double feed_mm_min) {
  const path::PathBlock block = feed_block(control, q_B_end, g, feed_mm_min);
  if (MaybeFailure failure = is_led_too_fast(control, block)) {
    return failure;
  }
  return travel(control, block);
}

namespace {

/// The axes to a machine position at rapid, whatever leads them.
MaybeFailure rapid_axes_to(Control& control, const AxisPositions& q_M_end, machine::RapidPath way) {
  path::PathBlock block;
  block.q_M_end = q_M_end;
  block.g = 0;
  block.where = control.block;
  block.ends = control.rapid_end();
  block.rapid_path = way;
  block.of_axes = true;
  return travel(control, block);
}

}  // namespace

MaybeFailure move_axes_to(Control& control, const AxisPositions& q_M_end, machine::RapidPath way) {
  if (control.modal.group[Group::Motion].whole != 1) {
    return rapid_axes_to(control, q_M_end, way);
  }
  const auto feed = feed_over(control, [&] { return axes_way(control, q_M_end); });
  if (!feed) {
    return feed.error();
  }
  path::PathBlock block = feed_block(control, q_M_end, 1, feed.value());
  block.of_axes = true;
  return travel(control, block);
}

namespace {

/// In a tilted plane nothing holds the tip while a rotary axis turns: the axes go straight to where
/// the block ends, and those that it does not name stay.
MaybeFailure turn_in_plane(Control& control, const NcBlock& block, const AxisPositions& q_L_end) {
  const AxisPositions q_B_end = control.coordinates.to_path(q_L_end);
  auto q_M_end = control.coordinates.axes_at(q_B_end);
  if (!q_M_end) {
    return block_failure(AlarmId::NoReachablePosition);
  }
  if (!block.words.has('X') && !block.words.has('Y') && !block.words.has('Z')) {
    q_M_end->head<kLinearAxisCount>() = linear_axes(control.port.position());
  }
  auto failure = move_axes_to(control, *q_M_end, control.rapid_path());
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

bool turns_in_plane(const Control& control, const AxisPositions& q_L_end) {
  const Coordinates& coordinates = control.coordinates;
  return coordinates.plane() && coordinates.tip_system() == TipSystem::None &&
         rotary_axes(q_L_end) != rotary_axes(coordinates.programmed());
}

}  // namespace

[[gnu::hot]] MaybeFailure execute_motion(Control& control, const NcBlock& block) {
  const int g = control.modal.group[Group::Motion].whole;
  const bool positions = control.positions_in_one_direction();
  if (control.modal.cuts_thread() && !positions) {
    return execute_thread(control, block);
  }
  if (!positions && (g == 2 || g == 3)) {
    return execute_arc(control, block);
  }
  AxisPositions q_L_end = programmed_end(control, block);
  if (auto failure = take_tool_direction(control, block, q_L_end)) {
    return failure;
  }
  if (turns_in_plane(control, q_L_end)) {
    return turn_in_plane(control, block, q_L_end);
  }
  const AxisPositions q_B_end = control.coordinates.to_path(q_L_end);
  if (auto failure =
          positions || g == 0 ? position_to(control, q_B_end) : feed_to(control, q_B_end, g)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  return std::nullopt;
}

/// G53: machine coordinates, this block only (MB-291), at rapid or as G00 or G01 is in force. Under
/// G91 it is ignored, or its values are a distance (M700V programming manual, 14.4 (4)).
MaybeFailure execute_machine_move(Control& control, const NcBlock& block) {
  if (!block.has_axis_word) {
    return std::nullopt;
  }
  const bool adds = control.modal.incremental();
  if (adds && !control.profile.machine_moves_add) {
    control.warn(source::DiagnosticId::MachineMoveIgnored, block.where);
    return std::nullopt;
  }
  AxisPositions q_M_end = control.port.position();
  const bool cancels = !adds && control.profile.machine_move_length == MachineMoveLength::Cancels;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      const auto place = static_cast<Eigen::Index>(axis);
      const double value = axis_value(control, *word, axis);
      q_M_end[place] = adds ? q_M_end[place] + value
                            : control.roll_over.end(static_cast<int>(axis), value, q_M_end[place]);
      if (cancels) {
        control.coordinates.end_tool_offset(static_cast<int>(axis));
      }
    }
  }
  const auto move = control.profile.machine_moves_by_mode ? move_axes_to : rapid_axes_to;
  auto failure = move(control, q_M_end, control.machine_rapid_path());
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

}  // namespace g31::fanuc

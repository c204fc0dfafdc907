// The direction of the tool: G53.1 and G53.6 turn it to a tilted plane, G43.4 and G43.5 hold its
// tip.  Sources: FANUC A-78712E p. 1380 (choice of G53.1), A-79348E pp. 20, 78 (G43.4, G43.5).

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "machine/kinematics/orientation.h"

namespace g31::fanuc {
namespace {

using machine::KinematicType;
using machine::OrientationAxes;
using machine::RotaryPair;
using machine::RotaryTravel;

/// G43.5
constexpr GNumber kByDirection{43, 5};

/// Pieces in which the speeds of led axes are looked at.
constexpr double kFeedPieceDeg = 2.0;
constexpr double kMostFeedPieces = 2000.0;

/// A component of a direction; without a point it counts increments, as the others of its block do.
double component(const Control& control, const BlockWords& words, char letter) {
  const EvaluatedWord* const word = words.find(letter);
  if (word == nullptr) {
    return 0.0;
  }
  const bool counts = word->form == syntax::ValueForm::Integer && !control.scale.calculator_point;
  return counts ? word->number / control.scale.length_counts() : word->number;
}

/// Which sign of the first rotary axis P of G53.1 asks for.
enum class FirstAxis { Either, Positive, Negative };

Result<FirstAxis, Failure> wanted_sign(const Control& control, const NcBlock& block) {
  const EvaluatedWord* const p = block.words.find('P');
  if (p == nullptr) {
    return FirstAxis::Either;
  }
  const auto number = integer_of(*p, control.profile);
  if (!number) {
    return number.error();
  }
  switch (number.value()) {
    case 0:
      return FirstAxis::Either;
    case 1:
      return FirstAxis::Positive;
    case 2:
      return FirstAxis::Negative;
    default:
      return at_word(AlarmId::TiltedPlaneFormat, *p, "P is 0, 1 or 2");
  }
}

RotaryTravel travel_of(const Control& control, int axis) {
  const auto travel = axis >= 0 ? control.port.travel(axis) : std::nullopt;
  return travel ? RotaryTravel{travel->min, travel->max} : RotaryTravel{};
}

/// The rotary axes for a direction of the tool in the part, nearest to where they stand: tables
/// first, else the axis that carries the other.
Result<AxisPositions, Failure> turned_to(const Control& control, const Point& d_P, FirstAxis sign) {
  const auto axes = OrientationAxes::of(control.coordinates.kinematics());
  if (!axes) {
    return block_failure(AlarmId::NoReachablePosition,
                         "the control knows no rotary axes that turn the tool");
  }
  AxisPositions q_M = control.port.position();
  std::array<RotaryTravel, 2> travel;
  std::array<double, 2> from = {0.0, 0.0};
  for (std::size_t i = 0; i < axes->count(); ++i) {
    travel.at(i) = travel_of(control, axes->axes().at(i));
    from.at(i) = q_M[axes->axes().at(i)];
  }
  if (sign == FirstAxis::Positive) {
    travel[0].lower = std::max(travel[0].lower, 0.0);
  } else if (sign == FirstAxis::Negative) {
    travel[0].upper = std::min(travel[0].upper, 0.0);
  }
  const std::size_t first = axes->type() == KinematicType::Mixed ? 1 : 0;
  const Point d_T = control.coordinates.tool_at_rest().linear().col(2);
  const auto pair = machine::least_motion(axes->pairs_for(d_P, d_T), from, travel, first);
  if (!pair) {
    return block_failure(AlarmId::NoReachablePosition,
                         fmt::format("no position of the rotary axes brings the tool along "
                                     "({:.6f}, {:.6f}, {:.6f})",
                                     d_P.x(), d_P.y(), d_P.z()));
  }
  for (std::size_t i = 0; i < axes->count(); ++i) {
    q_M[axes->axes().at(i)] = pair->deg.at(i);
  }
  return q_M;
}

/// G53.6: the rotary axes there, the tip at its place of the part.
MaybeFailure turn_about_tip(Control& control, const AxisPositions& q_M_turned) {
  AxisPositions q_B_end = control.path_position();
  q_B_end.tail<kRotaryAxisCount>() = rotary_axes(q_M_turned);
  return control.modal.group[Group::Motion].whole == 1
             ? feed_to(control, q_B_end, 1)
             : rapid_to(control, q_B_end, control.rapid_path());
}

}  // namespace

MaybeFailure execute_tool_to_plane(Control& control, const NcBlock& block) {
  constexpr int kAboutTip = 6;
  const auto& plane = control.coordinates.plane();
  if (!plane || control.transforms.space_centre) {
    return block_failure(AlarmId::NoTiltedPlane,
                         fmt::format("{} without a tilted plane", to_text(block.code->number)));
  }
  const auto sign = wanted_sign(control, block);
  if (!sign) {
    return sign.error();
  }
  if (block.has_axis_word) {
    control.warn_once(
        source::DiagnosticId::WordWithoutEffect, block.where,
        fmt::format("an axis beside {}, which turns the tool alone", to_text(block.code->number)));
  }
  const auto q_M = turned_to(control, plane->linear().col(2), sign.value());
  if (!q_M) {
    return q_M.error();
  }
  auto failure = block.code->number.tenth == kAboutTip
                     ? turn_about_tip(control, q_M.value())
                     : move_axes_to(control, q_M.value(), control.rapid_path());
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

MaybeFailure select_tip_control(Control& control) {
  const GNumber code = control.modal.group[Group::ToolLength];
  Coordinates& coordinates = control.coordinates;
  TipSystem system = TipSystem::None;
  if (find_g_code(code, control.profile)->action == GAction::TipControl) {
    system = control.parameters.is_on(ParameterId::TipInWorkSystem) ? TipSystem::Workpiece
                                                                    : TipSystem::OnTable;
  }
  if (system != TipSystem::None && !OrientationAxes::of(coordinates.kinematics())) {
    return block_failure(AlarmId::TipControlParameter,
                         "the control knows no rotary axes that turn the tool");
  }
  if (system == TipSystem::Workpiece && code == kByDirection) {
    return block_failure(AlarmId::NoReachablePosition, "G43.5 with parameter 19696.5 = 1");
  }
  if (system == TipSystem::Workpiece && coordinates.plane()) {
    return block_failure(AlarmId::TipControlParameter, "a tilted plane with parameter 19696.5 = 1");
  }
  if (system == coordinates.tip_system()) {
    return std::nullopt;
  }
  if (control.cutter.compensation.engaged()) {
    return block_failure(AlarmId::NotUnderTipControl, "cutter compensation is in force");
  }
  coordinates.set_tip_system(system);
  return std::nullopt;
}

MaybeFailure is_led_too_fast(const Control& control, const path::PathBlock& block) {
  const Coordinates& coordinates = control.coordinates;
  if (coordinates.tip_system() == TipSystem::None) {
    return std::nullopt;
  }
  const double most = control.parameters.get(ParameterId::LargestFeed);
  if (most <= 0.0) {
    return std::nullopt;
  }
  const AxisPositions q_B_from = control.path_position();
  const AxisPositions q_B_way = block.q_M_end - q_B_from;
  const double turned_deg = rotary_axes(q_B_way).cwiseAbs().maxCoeff();
  const double way_mm = linear_axes(q_B_way).norm();
  constexpr double kStandsMm = 1e-9;
  if (turned_deg == 0.0 || way_mm < kStandsMm) {
    return std::nullopt;
  }
  const int pieces = 1 + static_cast<int>(std::min(turned_deg / kFeedPieceDeg, kMostFeedPieces));
  const double minutes = way_mm / std::min(block.feed_mm_min, most) / pieces;
  auto q_M = coordinates.axes_at(q_B_from);
  for (int i = 1; q_M && i <= pieces; ++i) {
    const auto q_M_next =
        coordinates.axes_at(q_B_from + q_B_way * (static_cast<double>(i) / pieces));
    if (!q_M_next) {
      break;
    }
    const AxisPositions per_minute = (*q_M_next - *q_M) / minutes;
    Eigen::Index axis = 0;
    // As much as rounding makes of a speed that is just the largest.
    if (per_minute.cwiseAbs().maxCoeff(&axis) > most * (1.0 + 1e-9)) {
      return block_failure(AlarmId::TipControlTooFast,
                           fmt::format("{} would go at {:.0f} mm/min or deg/min, parameter 1422 is "
                                       "{:.0f}",
                                       kAxisLetters[static_cast<std::size_t>(axis)],
                                       std::abs(per_minute[axis]), most));
    }
    q_M = q_M_next;
  }
  return std::nullopt;
}

bool turns_by_direction(const Control& control, const BlockWords& words) {
  return control.modal.group[Group::ToolLength] == kByDirection &&
         (words.has('I') || words.has('J') || words.has('K'));
}

namespace {

MaybeFailure turn_by_direction(const Control& control, const NcBlock& block,
                               AxisPositions& q_L_end) {
  for (const char letter : {'A', 'B', 'C'}) {
    if (const EvaluatedWord* const word = block.words.find(letter)) {
      return at_word(AlarmId::NotUnderTipControl, *word,
                     "G43.5 takes the direction of the tool by I, J and K");
    }
  }
  if (!turns_by_direction(control, block.words)) {
    return std::nullopt;
  }
  const Point d_W(component(control, block.words, 'I'), component(control, block.words, 'J'),
                  component(control, block.words, 'K'));
  const double length = d_W.norm();
  if (!(length > 0.0)) {
    return block_failure(AlarmId::NotUnderTipControl, "I, J and K are all 0");
  }
  const auto& plane = control.coordinates.plane();
  const Point d_P = (plane ? Point(plane->linear() * d_W) : d_W) / length;
  const auto q_M = turned_to(control, d_P, FirstAxis::Either);
  if (!q_M) {
    return q_M.error();
  }
  q_L_end.tail<kRotaryAxisCount>() =
      rotary_axes(q_M.value()) - rotary_axes(control.coordinates.shift());
  return std::nullopt;
}

}  // namespace

MaybeFailure take_tool_direction(const Control& control, const NcBlock& block,
                                 AxisPositions& q_L_end) {
  return control.modal.group[Group::ToolLength] == kByDirection
             ? turn_by_direction(control, block, q_L_end)
             : std::nullopt;
}

}  // namespace g31::fanuc

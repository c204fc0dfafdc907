#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

/// How far an axis may stand off its reference point and still be on it.
constexpr double kOnReference = 1e-6;

/// mm or deg, machine coordinates.  @param which  1 to 4
double reference_point(const Control& control, int which, int axis) {
  return control.parameters.get_for_axis(ParameterId::ReferencePoint, which - 1, axis);
}

Result<int, Failure> which_reference(const Control& control, const NcBlock& block) {
  if (block.code->number.whole == 28) {
    return 1;
  }
  const EvaluatedWord* const p = block.words.find('P');
  if (p == nullptr) {
    return 2;
  }
  return integer_within(*p, control.profile, wrong_reference);
}

}  // namespace

/// G28, G30: the named axes go through the intermediate point to the reference point, at rapid
/// (MB-287 to MB-289).  The tool length offset of such an axis ends where it arrives, though G43
/// stays in force: FANUC 0i-MB manual B-63844EN/02, 14.1.2; M700V programming manual, 12.2 (4);
/// Haas 96-8000, G28.
MaybeFailure execute_reference(Control& control, const NcBlock& block) {
  const auto which = which_reference(control, block);
  if (!which) {
    return which.error();
  }
  const bool moves_all = !block.has_axis_word && control.profile.bare_reference_moves_all;
  if (!block.has_axis_word && !moves_all) {
    return std::nullopt;
  }
  const AxisPositions q_L_via = cartesian_end(control, block);
  const AxisPositions q_M_via = control.coordinates.to_path(q_L_via);
  if (auto failure = rapid_to(control, q_M_via, control.machine_rapid_path())) {
    return failure;
  }
  const auto goes = [&](int axis) {
    return moves_all || block.words.has(kAxisLetters[static_cast<std::size_t>(axis)]);
  };
  AxisPositions q_M_home = q_M_via;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    if (goes(axis)) {
      control.q_L_intermediate[static_cast<std::size_t>(axis)] = q_L_via[axis];
      q_M_home[axis] = control.roll_over.nearest(
          axis, reference_point(control, which.value(), axis), q_M_via[axis]);
    }
  }
  auto failure = rapid_to(control, q_M_home, machine::RapidPath::Independent);
  for (int axis = 0; axis < static_cast<int>(kAxisCount) && !failure; ++axis) {
    if (goes(axis)) {
      control.coordinates.end_tool_offset(axis);
    }
  }
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

/// G29: the named axes go through the intermediate point of their last G28 to the programmed point,
/// at rapid.  The point is remembered in work coordinates: it moves with them (MB-288).
MaybeFailure execute_from_reference(Control& control, const NcBlock& block) {
  AxisPositions q_L_via = control.coordinates.programmed();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (const EvaluatedWord* const word = block.words.find(kAxisLetters[axis])) {
      const std::optional<double>& via = control.q_L_intermediate[axis];
      if (!via) {
        return at_word(AlarmId::NoIntermediatePoint, *word,
                       fmt::format("{} has no intermediate point of a G28", word->letter));
      }
      double& end = q_L_via[static_cast<Eigen::Index>(axis)];
      end = control.roll_over.nearest(static_cast<int>(axis), *via, end);
    }
  }
  if (!block.has_axis_word) {
    return std::nullopt;
  }
  if (auto failure = rapid_to(control, control.coordinates.to_path(q_L_via),
                              machine::RapidPath::Independent)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_via);
  // An incremental end counts from the intermediate point.
  const AxisPositions q_L_end = cartesian_end(control, block);
  if (auto failure =
          rapid_to(control, control.coordinates.to_path(q_L_end), control.machine_rapid_path())) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  return std::nullopt;
}

/// G27: rapid to the programmed point; an axis that is then not on its reference point is alarm 092
/// (MB-317).
MaybeFailure execute_check_reference(Control& control, const NcBlock& block) {
  const AxisPositions q_L_end = cartesian_end(control, block);
  const AxisPositions q_M_end = control.coordinates.to_path(q_L_end);
  if (!block.has_axis_word) {
    return std::nullopt;
  }
  if (auto failure = rapid_to(control, q_M_end, control.rapid_path())) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
    const double off = q_M_end[axis] - control.roll_over.nearest(
                                           axis, reference_point(control, 1, axis), q_M_end[axis]);
    if (block.words.has(letter) && std::abs(off) > kOnReference) {
      return block_failure(AlarmId::ReferenceNotReached,
                           fmt::format("{} stands {:.4f} off its reference point", letter, off));
    }
  }
  return std::nullopt;
}

}  // namespace g31::fanuc

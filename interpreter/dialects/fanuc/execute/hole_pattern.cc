// G70, G71 and G72 of a Haas.  Source: Haas mill operator's manual 96-8000, bolt hole circle, bolt
// hole arc and bolt holes along an angle: they need one of the canned cycles, in force or in their
// own block; the tool stands at the centre, with G72 at the first hole, or X and Y bring it there.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/canned_cycle.h"
#include "interpreter/dialects/fanuc/execute/codes.h"

namespace g31::fanuc {
namespace {

constexpr int kCircle = 70;
constexpr int kLine = 72;
constexpr int kMostHoles = 9999;

/// As the words of its block say.
struct Pattern {
  int code = kCircle;
  double length_mm = 0.0;  ///< I: the radius, along a line from hole to hole
  double angle_deg = 0.0;  ///< J
  double step_deg = 0.0;   ///< from hole to hole; 0 along a line
  int holes = 0;           ///< L
};

/// Where a hole is from X Y of the block.
Eigen::Vector2d place_of(const Pattern& pattern, int hole) {
  const double radians = (pattern.angle_deg + hole * pattern.step_deg) * std::numbers::pi / 180.0;
  const double length = pattern.code == kLine ? hole * pattern.length_mm : pattern.length_mm;
  return length * Eigen::Vector2d(std::cos(radians), std::sin(radians));
}

Result<int, Failure> holes_of(const NcBlock& block) {
  const EvaluatedWord* const word = block.words.find('L');
  if (word == nullptr) {
    return block_failure(AlarmId::IllegalAddress,
                         fmt::format("{} needs L holes", to_text(block.code->number)));
  }
  return integer_within(*word, [](int number) {
    return number < 1 || number > kMostHoles
               ? MaybeWrong(
                     WrongValue{AlarmId::IllegalAddress, fmt::format("L is 1 to {}", kMostHoles)})
               : std::nullopt;
  });
}

Result<Pattern, Failure> pattern_of(const Control& control, const NcBlock& block) {
  constexpr double kFullTurnDeg = 360.0;
  const auto holes = holes_of(block);
  if (!holes) {
    return holes.error();
  }
  Pattern pattern;
  pattern.code = block.code->number.whole;
  pattern.holes = holes.value();
  const EvaluatedWord* const i = block.words.find('I');
  if (i == nullptr) {
    return block_failure(AlarmId::IllegalAddress,
                         fmt::format("{} needs I", to_text(block.code->number)));
  }
  pattern.length_mm = control.scale.length_mm(*i);
  const EvaluatedWord* const j = block.words.find('J');
  const EvaluatedWord* const k = block.words.find('K');
  pattern.angle_deg = j != nullptr ? control.scale.angle_deg(*j) : 0.0;
  if (pattern.code == kCircle) {
    pattern.step_deg = kFullTurnDeg / pattern.holes;
  } else if (pattern.code != kLine && k != nullptr) {
    pattern.step_deg = control.scale.angle_deg(*k);
  }
  return pattern;
}

}  // namespace

MaybeFailure execute_hole_pattern(Control& control, const NcBlock& block) {
  if (!in_canned_cycle(control)) {
    return block_failure(AlarmId::ImproperGCode, fmt::format("{} without a canned cycle in force",
                                                             to_text(block.code->number)));
  }
  const auto pattern = pattern_of(control, block);
  if (!pattern) {
    return pattern.error();
  }
  if (auto failure = take_cycle_data(control, block)) {
    return failure;
  }
  const Plane plane = cycle_plane(control);
  const AxisPositions q_L_from = programmed_end(control, block);
  for (int hole = 0; hole < pattern.value().holes; ++hole) {
    const Eigen::Vector2d apart = place_of(pattern.value(), hole);
    AxisPositions q_L = q_L_from;
    q_L[plane.first] += apart.x();
    q_L[plane.second] += apart.y();
    if (auto failure = drill_at(control, q_L)) {
      return failure;
    }
  }
  return std::nullopt;
}

}  // namespace g31::fanuc

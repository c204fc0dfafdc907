// G70, G71 and G72 of a Haas, G34, G35 and G36 of a MELDAS, G34.1 and G37.1 of a Mazak.  Sources:
// Haas mill operator's manual 96-8000, bolt hole circle, bolt hole arc and bolt holes along an
// angle: they need one of the canned cycles, in force or in their own block; the tool stands at the
// centre, with G72 at the first hole, or X and Y bring it there.  M700V programming manual, special
// fixed cycles: the data of the canned cycle come in a block of their own before it, with L0 where
// that is to drill no hole.  Mazak's are named alike by guides of others; the order of the holes of
// a grid they leave open: here each row begins where the one before it ended.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/canned_cycle.h"
#include "interpreter/dialects/fanuc/execute/codes.h"

namespace g31::fanuc {
namespace {

constexpr int kMostHoles = 9999;

enum class Shape { Circle, Arc, Line, Grid };

/// Which words of its block say what of a pattern; I is the radius, along a line from hole to hole,
/// and J the angle of the first hole, or of the line; of a grid I and J are from hole to hole.
struct PatternCode {
  CodeSet set;
  GNumber code;
  Shape shape;
  char count;             ///< how many holes; of a grid in a row
  char step;              ///< from hole to hole of an arc; of a grid how many rows
  bool takes_cycle_data;  ///< Z, R, Q and P of the block are of the canned cycle
  bool turns_clockwise;   ///< around a circle, where the number of holes is negative
};

constexpr PatternCode kPatternCodes[] = {
    {CodeSet::Haas, {70, 0}, Shape::Circle, 'L', '\0', true, false},
    {CodeSet::Haas, {71, 0}, Shape::Arc, 'L', 'K', true, false},
    {CodeSet::Haas, {72, 0}, Shape::Line, 'L', '\0', true, false},
    {CodeSet::Meldas, {34, 0}, Shape::Circle, 'K', '\0', false, true},
    {CodeSet::Meldas, {35, 0}, Shape::Line, 'K', '\0', false, false},
    {CodeSet::Meldas, {36, 0}, Shape::Arc, 'K', 'P', false, false},
    {CodeSet::Mazak, {34, 1}, Shape::Circle, 'K', '\0', false, true},
    {CodeSet::Mazak, {37, 1}, Shape::Grid, 'P', 'K', false, false},
};

const PatternCode& pattern_code(const GCode& code) {
  const auto* const row = std::ranges::find_if(kPatternCodes, [&](const PatternCode& pattern) {
    return pattern.set == code.set && pattern.code == code.number;
  });
  return *row;  // each row of g_codes.def with this action has one here: hole_pattern_test
}

/// As the words of its block say.
struct Pattern {
  Shape shape = Shape::Circle;
  double length_mm = 0.0;
  double angle_deg = 0.0;
  double step_deg = 0.0;  ///< from hole to hole; 0 along a line
  double row_mm = 0.0;    ///< of a grid: from row to row
  int in_row = 1;         ///< of a grid
  int holes = 0;
};

/// Where a hole of a grid is from X Y of the block: row by row, back and forth.
Eigen::Vector2d place_in_grid(const Pattern& pattern, int hole) {
  const int row = hole / pattern.in_row;
  const int along = hole % pattern.in_row;
  return {(row % 2 == 0 ? along : pattern.in_row - 1 - along) * pattern.length_mm,
          row * pattern.row_mm};
}

/// Where a hole is from X Y of the block.
Eigen::Vector2d place_of(const Pattern& pattern, int hole) {
  if (pattern.shape == Shape::Grid) {
    return place_in_grid(pattern, hole);
  }
  const double radians = (pattern.angle_deg + hole * pattern.step_deg) * std::numbers::pi / 180.0;
  const double length = pattern.shape == Shape::Line ? hole * pattern.length_mm : pattern.length_mm;
  return length * Eigen::Vector2d(std::cos(radians), std::sin(radians));
}

/// @param address  that says how many; below 0 where they go clockwise
Result<int, Failure> holes_of(const Control& control, const NcBlock& block, const PatternCode& code,
                              char address) {
  const EvaluatedWord* const word = block.words.find(address);
  if (word == nullptr) {
    return block_failure(AlarmId::NoHoles,
                         fmt::format("{} needs {} holes", to_text(block.code->number), address));
  }
  return integer_within(*word, control.profile, [&](int number) {
    const int holes = code.turns_clockwise ? std::abs(number) : number;
    return holes < 1 || holes > kMostHoles
               ? MaybeWrong(WrongValue{AlarmId::NoHoles,
                                       fmt::format("{} is 1 to {}", address, kMostHoles)})
               : std::nullopt;
  });
}

/// I P J K: columns and rows.
Result<Pattern, Failure> grid_of(const Control& control, const NcBlock& block,
                                 const PatternCode& code) {
  const auto in_row = holes_of(control, block, code, code.count);
  if (!in_row) {
    return in_row.error();
  }
  const auto rows = holes_of(control, block, code, code.step);
  if (!rows) {
    return rows.error();
  }
  const EvaluatedWord* const i = block.words.find('I');
  const EvaluatedWord* const j = block.words.find('J');
  if ((i == nullptr && in_row.value() > 1) || (j == nullptr && rows.value() > 1)) {
    return block_failure(AlarmId::IllegalAddress,
                         fmt::format("{} needs I and J", to_text(block.code->number)));
  }
  Pattern pattern;
  pattern.shape = Shape::Grid;
  pattern.length_mm = i != nullptr ? control.scale.length_mm(*i) : 0.0;
  pattern.row_mm = j != nullptr ? control.scale.length_mm(*j) : 0.0;
  pattern.in_row = in_row.value();
  pattern.holes = in_row.value() * rows.value();
  return pattern;
}

/// From hole to hole.
double step_deg(const Control& control, const NcBlock& block, const PatternCode& code, int holes) {
  constexpr double kFullTurnDeg = 360.0;
  if (code.shape == Shape::Circle) {
    return kFullTurnDeg / holes;
  }
  const EvaluatedWord* const word =
      code.shape == Shape::Arc ? block.words.find(code.step) : nullptr;
  return word != nullptr ? control.scale.angle_deg(*word) : 0.0;
}

Result<Pattern, Failure> pattern_of(const Control& control, const NcBlock& block,
                                    const PatternCode& code) {
  if (code.shape == Shape::Grid) {
    return grid_of(control, block, code);
  }
  const auto holes = holes_of(control, block, code, code.count);
  if (!holes) {
    return holes.error();
  }
  const EvaluatedWord* const i = block.words.find('I');
  if (i == nullptr) {
    return block_failure(AlarmId::IllegalAddress,
                         fmt::format("{} needs I", to_text(block.code->number)));
  }
  const EvaluatedWord* const j = block.words.find('J');
  const double step = step_deg(control, block, code, holes.value());
  if (code.shape == Shape::Arc && step == 0.0) {
    return block_failure(AlarmId::NoAngleStep,
                         fmt::format("{} needs {}", to_text(block.code->number), code.step));
  }
  Pattern pattern;
  pattern.shape = code.shape;
  pattern.length_mm = control.scale.length_mm(*i);
  pattern.angle_deg = j != nullptr ? control.scale.angle_deg(*j) : 0.0;
  pattern.step_deg = step;
  pattern.holes = std::abs(holes.value());
  return pattern;
}

}  // namespace

MaybeFailure execute_hole_pattern(Control& control, const NcBlock& block) {
  if (!in_canned_cycle(control)) {
    return block_failure(AlarmId::ImproperGCode, fmt::format("{} without a canned cycle in force",
                                                             to_text(block.code->number)));
  }
  const PatternCode& code = pattern_code(*block.code);
  const auto pattern = pattern_of(control, block, code);
  if (!pattern) {
    return pattern.error();
  }
  if (code.takes_cycle_data) {
    if (auto failure = take_cycle_data(control, block)) {
      return failure;
    }
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

#pragma once

#include <cstddef>
#include <vector>

#include "tools/evaluate/evaluation.h"

namespace g31::evaluate {

/// Deviations at places of one distance, mm.
struct EvenTable {
  double first = 0.0;
  double step = 0.0;
  std::vector<double> values = {};

  [[nodiscard]] double place(std::size_t n) const { return first + static_cast<double>(n) * step; }
};

/// The deviation at a place: straight between the points, that of the nearest point beyond them.
/// @pre the curve has a point, and its places rise
double deviation_at(const Curve& curve, double place);

/// The curve's own points where they have one distance, within a nanometre; else four steps in the
/// place of each, 200 points at most, on the lines between its points.
/// @pre the curve has two points or more
EvenTable even_table(const Curve& curve);

/// On multiples of a step, from the one at or before the curve to the one at or behind it.
EvenTable table_on_multiples(const Curve& curve, double step);

}  // namespace g31::evaluate

#pragma once

#include <cstddef>
#include <vector>

#include "machine/errors/error_table.h"
#include "tools/evaluate/evaluation.h"

namespace g31::evaluate {

/// Deviations at places of one distance, mm.
struct EvenTable {
  double first = 0.0;
  double step = 0.0;
  std::vector<double> values = {};

  [[nodiscard]] double place(std::size_t n) const { return first + static_cast<double>(n) * step; }
};

/// Straight between the points, constant beyond them.
/// @pre places rise
errors::ErrorTable error_table(const Curve& curve);

/// The most that lines between a table's points leave of a curve at its places, mm.
double left_at_places(const Curve& curve, const EvenTable& table);

/// The smallest distance of two places, mm.
/// @pre the curve has two points or more
double smallest_distance(const Curve& curve);

/// The curve's own points where they have one distance, within a nanometre.  Else points on the
/// lines between them, as far apart as its nearest two or a whole part of that: the widest that
/// leave nothing worth a word at the curve's places, or those of all that leave least.
/// @param most  points at most
/// @pre the curve has two points or more
EvenTable even_table(const Curve& curve, std::size_t most);

/// On multiples of a step, from the one at or before the curve to the one at or behind it.
EvenTable table_on_multiples(const Curve& curve, double step);

}  // namespace g31::evaluate

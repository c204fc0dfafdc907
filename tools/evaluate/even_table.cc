#include "tools/evaluate/even_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/base/contract.h"

namespace g31::evaluate {
namespace {

constexpr double kSamePlace = 1e-6;  // mm
/// Of a table of an 828D.  Source: function manual K3, 6FC5397-1BP40-3BA1, page 264.
constexpr std::size_t kMostPoints = 200;
constexpr std::size_t kStepsBetweenPoints = 4;

bool is_even(const Curve& curve, double step) {
  const double first = curve.points.front()[0];
  for (std::size_t n = 0; n < curve.points.size(); ++n) {
    if (std::abs(curve.points[n][0] - first - static_cast<double>(n) * step) > kSamePlace) {
      return false;
    }
  }
  return true;
}

EvenTable table_of(const Curve& curve, double first, double step, std::size_t count) {
  const errors::ErrorTable deviations = error_table(curve);
  EvenTable table{first, step, {}};
  for (std::size_t n = 0; n < count; ++n) {
    table.values.push_back(deviations.at(table.place(n)));
  }
  return table;
}

}  // namespace

errors::ErrorTable error_table(const Curve& curve) {
  std::vector<errors::ErrorTable::Row> rows;
  for (const auto& [place, deviation] : curve.points) {
    rows.push_back({place, deviation});
  }
  return errors::ErrorTable(std::move(rows));
}

EvenTable even_table(const Curve& curve) {
  G31_EXPECTS(curve.points.size() >= 2);
  const double first = curve.points.front()[0];
  const double length = curve.points.back()[0] - first;
  std::size_t steps = curve.points.size() - 1;
  if (!is_even(curve, length / static_cast<double>(steps))) {
    steps = std::max(steps, std::min(kStepsBetweenPoints * steps, kMostPoints - 1));
  }
  return table_of(curve, first, length / static_cast<double>(steps), steps + 1);
}

EvenTable table_on_multiples(const Curve& curve, double step) {
  const double low = std::floor(curve.points.front()[0] / step + kSamePlace);
  const double high = std::ceil(curve.points.back()[0] / step - kSamePlace);
  return table_of(curve, low * step, step, static_cast<std::size_t>(high - low) + 1);
}

}  // namespace g31::evaluate

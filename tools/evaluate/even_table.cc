#include "tools/evaluate/even_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "machine/base/contract.h"

namespace g31::evaluate {
namespace {

constexpr double kSamePlace = 1e-6;  // mm
/// Less is 0.0 um where tenths are written, mm.
constexpr double kNothingLeft = 0.00005;

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

double left_at_places(const Curve& curve, const EvenTable& table) {
  const auto last = static_cast<double>(table.values.size() - 1);
  double most = 0.0;
  for (const auto& [place, deviation] : curve.points) {
    const double along = std::clamp((place - table.first) / table.step, 0.0, last);
    const auto n = static_cast<std::size_t>(std::min(along, last - 1.0));
    const double share = along - static_cast<double>(n);
    const double on_line = (1.0 - share) * table.values[n] + share * table.values[n + 1];
    most = std::max(most, std::abs(deviation - on_line));
  }
  return most;
}

double smallest_distance(const Curve& curve) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 1; n < curve.points.size(); ++n) {
    smallest = std::min(smallest, curve.points[n][0] - curve.points[n - 1][0]);
  }
  return smallest;
}

EvenTable even_table(const Curve& curve, std::size_t most) {
  G31_EXPECTS(curve.points.size() >= 2);
  const double first = curve.points.front()[0];
  const double length = curve.points.back()[0] - first;
  const auto sections = static_cast<double>(curve.points.size() - 1);
  const double finest = length / static_cast<double>(most - 1);
  if (const double step = length / sections; step >= finest && is_even(curve, step)) {
    return table_of(curve, first, step, curve.points.size());
  }
  const double widest = smallest_distance(curve);
  EvenTable best;
  double left = std::numeric_limits<double>::infinity();
  for (double parts = 1.0, step = 0.0; left > kNothingLeft && step != finest; ++parts) {
    step = std::max(widest / parts, finest);
    const double steps = std::ceil(length / step - kSamePlace);
    EvenTable table = table_of(curve, first, step, static_cast<std::size_t>(steps) + 1);
    if (const double now = left_at_places(curve, table); now < left) {
      left = now;
      best = std::move(table);
    }
  }
  return best;
}

EvenTable table_on_multiples(const Curve& curve, double step) {
  const double low = std::floor(curve.points.front()[0] / step + kSamePlace);
  const double high = std::ceil(curve.points.back()[0] / step - kSamePlace);
  return table_of(curve, low * step, step, static_cast<std::size_t>(high - low) + 1);
}

}  // namespace g31::evaluate

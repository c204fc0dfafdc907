#include "machine/sim/axis_corrections.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/base/contract.h"

namespace g31::machine {

AxisCorrections::AxisCorrections(const std::vector<CompensationTable>& tables) {
  for (const CompensationTable& table : tables) {
    G31_EXPECTS(!table.factors.empty());
    Table kept{table.compensated, {}, static_cast<double>(table.direction)};
    for (const CompensationTable::Factor& factor : table.factors) {
      G31_EXPECTS(!factor.points.empty() && factor.period >= 0.0);
      std::vector<errors::ErrorTable::Row> rows;
      for (const auto& [place, value] : factor.points) {
        G31_EXPECTS(std::isfinite(place) && std::isfinite(value));
        rows.push_back({place, value});
      }
      kept.factors.push_back({factor.axis, errors::ErrorTable(std::move(rows)),
                              factor.points.front().first, factor.period});
    }
    tables_.push_back(std::move(kept));
  }
}

double AxisCorrections::Factor::at(const AxisPositions& q_M) const {
  const double place = q_M[axis];
  return table.at(period > 0.0 ? place - period * std::floor((place - begin) / period) : place);
}

bool AxisCorrections::depend_on_direction() const {
  return std::ranges::any_of(tables_, [](const Table& table) { return table.direction != 0.0; });
}

AxisPositions AxisCorrections::at(const AxisPositions& q_M, const AxisPositions& direction) const {
  AxisPositions sum = AxisPositions::Zero();
  for (const Table& table : tables_) {
    if (table.direction != 0.0 && table.direction != direction[table.factors.front().axis]) {
      continue;
    }
    double product = 1.0;
    for (const Factor& factor : table.factors) {
      product *= factor.at(q_M);
    }
    sum[table.compensated] += product;
  }
  return sum;
}

}  // namespace g31::machine

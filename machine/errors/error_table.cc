#include "machine/errors/error_table.h"

#include <algorithm>
#include <utility>

#include "machine/base/contract.h"

namespace g31::errors {

ErrorTable::ErrorTable(std::vector<Row> rows) : rows_(std::move(rows)) {
  const auto not_rising = [](const Row& a, const Row& b) { return !(a.place < b.place); };
  G31_EXPECTS(std::ranges::adjacent_find(rows_, not_rising) == rows_.end());
}

double ErrorTable::at(double place) const {
  if (rows_.empty()) {
    return 0.0;
  }
  const auto above = std::ranges::upper_bound(rows_, place, {}, &Row::place);
  if (above == rows_.begin()) {
    return rows_.front().error;
  }
  if (above == rows_.end()) {
    return rows_.back().error;
  }
  const Row& low = *(above - 1);
  return low.error + (place - low.place) / (above->place - low.place) * (above->error - low.error);
}

bool ErrorTable::is_zero() const {
  return std::ranges::all_of(rows_, [](const Row& row) { return row.error == 0.0; });
}

}  // namespace g31::errors

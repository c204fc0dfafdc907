#pragma once

#include <vector>

#include "machine/errors/error_table.h"
#include "machine/port/axis_data.h"

namespace g31::machine {

/// What a control adds to the places of its axes by tables.
class AxisCorrections {
 public:
  AxisCorrections() = default;
  explicit AxisCorrections(const std::vector<CompensationTable>& tables);

  [[nodiscard]] bool are_none() const { return tables_.empty(); }

  /// Whether any counts in one direction only.
  [[nodiscard]] bool depend_on_direction() const;

  /// mm or deg, to be added where the encoders say q_M.
  /// @param direction  in which each axis goes or last went, +1 or -1; 0: it has not moved yet
  [[nodiscard]] AxisPositions at(const AxisPositions& q_M, const AxisPositions& direction) const;

 private:
  struct Factor {
    Eigen::Index axis = 0;
    errors::ErrorTable table;
    double begin = 0.0;
    double period = 0.0;  // 0: it does not go round

    [[nodiscard]] double at(const AxisPositions& q_M) const;
  };
  struct Table {
    Eigen::Index compensated = 0;
    std::vector<Factor> factors;
    double direction = 0.0;  // 0: it always counts
  };

  std::vector<Table> tables_;
};

}  // namespace g31::machine

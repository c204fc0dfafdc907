#pragma once

#include <vector>

namespace g31::errors {

/// An error that was measured at places along an axis; without places it is 0 everywhere.
class ErrorTable {
 public:
  struct Row {
    double place = 0.0;  ///< mm, machine coordinate of the axis
    double error = 0.0;
  };

  ErrorTable() = default;

  /// @param rows  places rising, all numbers finite
  explicit ErrorTable(std::vector<Row> rows);

  /// Straight between the places, constant outside them.
  [[nodiscard]] double at(double place) const;

  [[nodiscard]] bool is_zero() const;

 private:
  std::vector<Row> rows_;
};

}  // namespace g31::errors

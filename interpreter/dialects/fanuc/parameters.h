#pragma once

#include <map>
#include <optional>
#include <string>

#include "machine/base/result.h"

namespace g31::fanuc {

/// Control parameters as the set-up sheet or G10 L50 gives them; what is not given is 0.
class Parameters {
 public:
  /// @param entries  "6001.1" bit 1 of 6001, "3410" a value, "1240.X" a value of one axis
  /// @returns the parameters, or the name that is neither
  static Result<Parameters, std::string> from(const std::map<std::string, double>& entries);

  [[nodiscard]] double value(int number, double otherwise = 0.0) const;
  [[nodiscard]] bool bit(int number, int bit) const;
  /// The value of one axis; where only the number has one, that.  @param axis  storage index
  [[nodiscard]] double axis_value(int number, int axis) const;

  /// Whether a parameter of signal bits has one that is on.
  [[nodiscard]] bool selects(int number) const;

  /// What G10 L50 writes: a value, whose digits are bits 7 to 0 where it has only ones and zeros.
  void set(int number, double value);
  void set_axis_value(int number, int axis, double value) { axis_values_[{number, axis}] = value; }

 private:
  std::map<int, double> values_;
  std::map<std::pair<int, int>, bool> bits_;
  std::map<std::pair<int, int>, double> axis_values_;
};

}  // namespace g31::fanuc

#pragma once

#include <map>
#include <optional>
#include <string>

#include "machine/base/result.h"

namespace g31::fanuc {

/// Control parameters as the set-up sheet or G10 L50 gives them; what is not given is 0.
class Parameters {
 public:
  /// @param entries  "6001.1" bit 1 of 6001, "3410" a value
  /// @returns the parameters, or the name that is neither
  static Result<Parameters, std::string> from(const std::map<std::string, double>& entries);

  [[nodiscard]] double value(int number, double otherwise = 0.0) const;
  [[nodiscard]] bool bit(int number, int bit) const;
  void set_value(int number, double value) { values_[number] = value; }
  void set_bit(int number, int bit, bool on) { bits_[{number, bit}] = on; }

 private:
  std::map<int, double> values_;
  std::map<std::pair<int, int>, bool> bits_;
};

}  // namespace g31::fanuc

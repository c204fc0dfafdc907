#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::fanuc {

enum class ParameterId {
#define BIT_PARAMETER(name, number, bit, text) name,
#define VALUE_PARAMETER(name, first, last, unit, initial, text) name,
#include "interpreter/dialects/fanuc/parameters.def"
#undef VALUE_PARAMETER
#undef BIT_PARAMETER
};

/// One row of parameters.def.
struct ParameterInfo {
  int first;
  int last;
  std::optional<int> bit;  ///< none: a value
  std::string_view unit;
  double initial;  ///< where nothing sets it
  std::string_view text;
};

/// All rows, rising.
std::span<const ParameterInfo> parameter_rows();

const ParameterInfo& info(ParameterId id);

/// Control parameters as the set-up sheet or G10 L50 gives them.
class Parameters {
 public:
  /// @param entries  "6001.1" bit 1 of 6001, "3410" a value
  /// @returns the parameters, or the name that is neither
  static Result<Parameters, std::string> from(const std::map<std::string, double>& entries);

  [[nodiscard]] bool is_on(ParameterId id) const;
  /// @param index  which of the row's numbers, from 0
  [[nodiscard]] double get(ParameterId id, int index = 0) const;
  void switch_to(ParameterId id, bool on);
  void set(ParameterId id, double value);

  // By number; `otherwise` where nothing sets it.
  [[nodiscard]] double value(int number, double otherwise = 0.0) const;
  [[nodiscard]] bool bit(int number, int bit) const;
  void set_value(int number, double value) { values_[number] = value; }
  void set_bit(int number, int bit, bool on) { bits_[{number, bit}] = on; }

 private:
  std::map<int, double> values_;
  std::map<std::pair<int, int>, bool> bits_;
};

}  // namespace g31::fanuc

#pragma once

#include <bitset>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc {

enum class ParameterId {
#define BIT_PARAMETER(name, number, bit, text) name,
#define VALUE_PARAMETER(name, first, last, unit, initial, text) name,
#define IDLE_PARAMETER(name, first, last, unit, text) name,
#include "interpreter/dialects/fanuc/vocabulary/parameters.def"
#undef IDLE_PARAMETER
#undef VALUE_PARAMETER
#undef BIT_PARAMETER
};

/// How many rows parameters.def has.
inline constexpr std::size_t kParameterCount = 0
#define BIT_PARAMETER(name, number, bit, text) +1
#define VALUE_PARAMETER(name, first, last, unit, initial, text) +1
#define IDLE_PARAMETER(name, first, last, unit, text) +1
#include "interpreter/dialects/fanuc/vocabulary/parameters.def"
#undef IDLE_PARAMETER
#undef VALUE_PARAMETER
#undef BIT_PARAMETER
    ;

/// One row of parameters.def.
struct ParameterInfo {
  int first;
  int last;
  std::optional<int> bit;  ///< none: a value
  std::string_view unit;
  double initial;  ///< where nothing sets it
  std::string_view text;
  bool is_idle = false;  ///< known, and it changes nothing here: a sheet that sets it is told so
};

/// All rows, rising.
std::span<const ParameterInfo> parameter_rows();

const ParameterInfo& info(ParameterId id);

/// The first row that holds the number, or nullptr: a parameter that changes nothing here.
const ParameterInfo* find_parameter(int number);

/// Whether what a sheet calls so changes anything here: "6001.1", "3410", "1240.X".
bool has_effect(std::string_view name);

/// Storage index of a controlled axis.
/// @param axes    the letters of all of them, as parameter 1020 has them
/// @param number  counted from 0; nullopt: there is none of this number
constexpr std::optional<int> controlled_axis(std::string_view axes, int number) {
  const auto place = static_cast<std::size_t>(number);
  return number >= 0 && place < axes.size() ? std::optional(axis_index(axes[place])) : std::nullopt;
}

/// Control parameters as the set-up sheet or G10 L50 gives them.
class Parameters {
 public:
  /// @param entries  "6001.1" bit 1 of 6001, "3410" a value, "1240.X" a value of one axis
  /// @returns the parameters, or the name that is neither
  static Result<Parameters, std::string> from(const std::map<std::string, double>& entries);

  /// Whether anything has said how a bit is.
  [[nodiscard]] bool is_given(ParameterId id) const;
  /// A bit; of a row that is none it is off.
  [[nodiscard]] bool is_on(ParameterId id) const { return on_[static_cast<std::size_t>(id)]; }
  /// Of one axis, where that has digits of its own.  @param axis  storage index
  [[nodiscard]] bool is_on_for_axis(ParameterId id, int axis) const;
  /// @param index  which of the row's numbers, from 0
  [[nodiscard]] double get(ParameterId id, int index = 0) const;
  /// The value of one axis; where only the number has one, that.  @param axis  storage index
  [[nodiscard]] double get_for_axis(ParameterId id, int index, int axis) const;
  /// A value that is a row of signals: bit i is signal i + 1, set by bits or as a whole.
  [[nodiscard]] unsigned signals(ParameterId id, int index) const;
  void switch_to(ParameterId id, bool on);
  void set(ParameterId id, double value);

  /// The first reference point, where nothing has set it.
  void set_reference(const AxisPositions& q_M);

  /// What PRM shows: a value, or the bits of the parameter as a number.
  [[nodiscard]] double shown(int number) const;
  [[nodiscard]] double shown_bit(int number, int bit) const;
  [[nodiscard]] double shown_for_axis(int number, int axis) const;

  // By number; `otherwise` where nothing sets it.
  [[nodiscard]] double value(int number, double otherwise = 0.0) const;
  [[nodiscard]] bool bit(int number, int bit) const;
  [[nodiscard]] bool has(int number) const { return values_.contains(number); }
  /// For all axes, where it has one for each.
  void set_value(int number, double value);
  void set_axis_value(int number, int axis, double value) { axis_values_[{number, axis}] = value; }
  /// What G10 L50 writes: where the number is one of bits, the digits are bits 7 to 0.
  /// @returns whether the control takes such a value
  [[nodiscard]] bool enter(int number, double value);
  void set_bit(int number, int bit, bool on);

  bool operator==(const Parameters&) const = default;

 private:
  std::map<int, double> values_;
  std::map<std::pair<int, int>, bool> bits_;
  std::bitset<kParameterCount> on_;  ///< of bits_ those that have a row: each block asks for some
  std::map<std::pair<int, int>, double> axis_values_;
};

}  // namespace g31::fanuc

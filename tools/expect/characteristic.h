#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "interpreter/source/source_map.h"

namespace g31::expect {

/// What a result is.
enum class Quantity : std::uint8_t { Length, Angle, Number };

/// A row of result_units.def.
struct ResultUnit {
  std::string_view name;
  Quantity quantity = Quantity::Length;
  double mm = 0.0;  ///< of one of it; 0: it is no length
};

inline constexpr ResultUnit kResultUnits[] = {
#define RESULT_UNIT(name, quantity, mm) {name, Quantity::quantity, mm},
#include "tools/expect/result_units.def"
#undef RESULT_UNIT
};

/// A limit in decimal digits is none in binary ones: so much of it more does no harm.
inline constexpr double kLimitSlack = 1e-9;

/// What a deviation from the nominal may be.
struct Limits {
  double lower = 0.0;
  double upper = 0.0;
};

/// By how much a deviation is beyond a limit; 0: it is within them.
double excess_of(double deviation, const Limits& limits);

/// What a simulated part truly is at 20 degrees, and a result is to come to.
struct TrueSize {
  std::string part;    ///< its name
  std::string key;     ///< of the size
  double value = 0.0;  ///< mm, of an angle degrees
  Quantity quantity = Quantity::Length;
};

/// A size that a program measures: one [[characteristic]].  Numbers are in its unit.
struct Characteristic {
  std::string name;      ///< for people
  std::string variable;  ///< as --print takes it
  ResultUnit unit = kResultUnits[0];
  std::optional<double> nominal;
  std::optional<Limits> tolerance;    ///< only with a nominal; none: every value is as good
  std::optional<TrueSize> true_size;  ///< of the same quantity as the unit
  source::ShownPlace place;           ///< of its variable in the sheet

  /// In its unit; nullopt: not known.
  [[nodiscard]] std::optional<double> true_value() const;
};

enum class CharacteristicVerdict : std::uint8_t {
  Good,
  Bad,
  Missing,   ///< the program has not come to a number
  Reported,  ///< there are no limits to judge it by
};

/// As documents call it: "good".
std::string_view name_of(CharacteristicVerdict verdict);

/// A characteristic and what the run came to.
struct MeasuredCharacteristic {
  Characteristic what;
  std::optional<double> actual;  ///< nullopt: no number

  [[nodiscard]] std::optional<double> deviation() const;        ///< from the nominal
  [[nodiscard]] std::optional<double> measuring_error() const;  ///< from the true size
  [[nodiscard]] CharacteristicVerdict verdict() const;
};

}  // namespace g31::expect

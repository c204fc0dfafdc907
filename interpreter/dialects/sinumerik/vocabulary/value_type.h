#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace g31::sinumerik {

/// The data types of the language.  Everything but STRING and FRAME is kept as a double: INT of 32
/// bits, CHAR, BOOL and the index of an AXIS are exact in it.
enum class Type : std::uint8_t { None, Bool, Char, Int, Real, Axis, String, Frame };

constexpr bool is_number(Type type) {
  return type == Type::Bool || type == Type::Char || type == Type::Int || type == Type::Real;
}
constexpr bool is_held_as_number(Type type) {
  return is_number(type) || type == Type::Axis;
}

inline constexpr auto kTypeNames = std::to_array<std::string_view>(
    {"?", "BOOL", "CHAR", "INT", "REAL", "AXIS", "STRING", "FRAME"});

constexpr std::string_view name_of(Type type) {
  return kTypeNames[static_cast<std::size_t>(type)];
}

/// "REAL" as DEF and PROC write it, upper case.
constexpr std::optional<Type> type_named(std::string_view name) {
  for (std::size_t i = 1; i < kTypeNames.size(); ++i) {
    if (kTypeNames[i] == name) {
      return static_cast<Type>(i);
    }
  }
  return std::nullopt;
}

/// An AXIS variable that was never set.
inline constexpr double kNoAxis = -1.0;

/// The value of a variable without one.
constexpr double initial_number(Type type) {
  return type == Type::Axis ? kNoAxis : 0.0;
}

/// What of a datum counts in the unit of length that a program has chosen.
enum class DatumUnit : std::uint8_t {
  Plain,   ///< nothing
  Length,  ///< kept in mm or mm/min
  Metres,  ///< kept in m/s^2 or m/s^3
};

/// How an array is laid out; a single variable has none of the sizes.
struct Shape {
  static constexpr int kMostDimensions = 3;
  int dimensions = 0;
  std::array<int, kMostDimensions> size = {1, 1, 1};

  [[nodiscard]] constexpr int count() const { return size[0] * size[1] * size[2]; }
  friend bool operator==(const Shape&, const Shape&) = default;
};

}  // namespace g31::sinumerik

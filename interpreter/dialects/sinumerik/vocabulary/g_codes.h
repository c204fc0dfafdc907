#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace g31::sinumerik {

enum class GAction : std::uint8_t {
  Modal,     ///< sets its group, nothing else
  OneBlock,  ///< a switch for its own block
  Dwell,
  Reference,
  FixedPoint,
  Frame,
  AxialShift,   ///< G58, G59
  SolidAngles,  ///< ROTS
  Pole,
  LowerLimit,  ///< G25, G26
  UpperLimit,
  Refused,
};

struct GCode {
  std::string_view name;
  int group;
  int number;
  GAction action;
  std::string_view text;
};

inline constexpr int kGroupCount = 64;

/// All rows of g_codes.def.
std::span<const GCode> g_codes();

/// A row, and what G505 to G599 add to its number.
struct FoundCode {
  std::uint16_t row = 0;
  std::uint16_t beyond = 0;
};

/// @param name  upper case, without leading zeros: "G1", "SUPA", "G507"
std::optional<FoundCode> find_g_code(std::string_view name);
/// G and a number.
std::optional<FoundCode> find_g_code(double number);

/// A code of a block in one number, and back: so many rows, and so many numbers beyond one.
inline constexpr int kPackedCount = 256;
constexpr std::uint16_t packed(FoundCode code) {
  return static_cast<std::uint16_t>(code.row | (code.beyond << 8));
}
constexpr FoundCode unpacked(std::uint16_t bits) {
  return {static_cast<std::uint16_t>(bits & 0xFF), static_cast<std::uint16_t>(bits >> 8)};
}

/// The code of a group that is in force after reset.
int preset_number(int group);

}  // namespace g31::sinumerik

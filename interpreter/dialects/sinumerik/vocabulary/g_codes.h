#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "machine/base/indexed_by.h"

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

/// Whether a code takes the words of its block for something else than a motion of the path.
constexpr bool takes_words(GAction action) {
  return action != GAction::Modal && action != GAction::OneBlock && action != GAction::Refused;
}

/// Groups of codes; the value is the number of $P_GG.
enum class Group : std::uint8_t {
#define G_GROUP(name, number, text) name = number,
#include "interpreter/dialects/sinumerik/vocabulary/g_groups.def"
#undef G_GROUP
};

struct GCode {
  std::string_view name;
  Group group;
  int number;
  GAction action;
  std::string_view text;
};

inline constexpr int kGroupCount = 64;

/// Whose codes count in their own block only.
inline constexpr Group kOneBlockGroups[] = {Group::OneBlock, Group::ProgrammableFrame,
                                            Group::FrameSuppression, Group::ExactStop};

/// One value for each group: the number, within the group, of the code in force.
using GroupNumbers = IndexedBy<Group, int, kGroupCount>;

/// A code's number within its group, looked up when compiling.
consteval int number_in_group(std::string_view code) {
#define G_CODE(name, group, number, action, text) \
  if (code == name) {                             \
    return number;                                \
  }
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.def"
#undef G_CODE
  throw "no such code";
}

/// Numbers of group 1 that go along an arc by its centre, radius or angle.
constexpr bool is_arc(int motion) {
  return motion == number_in_group("G2") || motion == number_in_group("G3");
}
/// Those, and through a point or at a tangent.
constexpr bool is_circle(int motion) {
  return is_arc(motion) || motion == number_in_group("CIP") || motion == number_in_group("CT");
}

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

/// The code of a group that $P_GG shows as a number.
std::optional<FoundCode> find_g_code(double group, double number);

/// As programs write it.
std::string name_of(FoundCode code);

/// A code of a block in one number, and back: so many rows, and so many numbers beyond one.
inline constexpr int kPackedCount = 256;
constexpr std::uint16_t packed(FoundCode code) {
  return static_cast<std::uint16_t>(code.row | (code.beyond << 8));
}
constexpr FoundCode unpacked(std::uint16_t bits) {
  return {static_cast<std::uint16_t>(bits & 0xFF), static_cast<std::uint16_t>(bits >> 8)};
}

/// The code of a group that is in force after reset.
int preset_number(Group group);

}  // namespace g31::sinumerik

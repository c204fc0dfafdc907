#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace g31::fanuc {

/// One row of canned_cycles.def, which says what each value means.
struct CannedCycle {
  enum class Feeding : std::uint8_t { Straight, ChipBreak, FullRetract, Back };
  enum class Dwell : std::uint8_t { None, Bottom, BottomAndR };
  enum class Shift : std::uint8_t { None, Aside };
  enum class Retract : std::uint8_t { Rapid, Feed, Hand };

  int code;  ///< 81 for G81
  Feeding feeding;
  Dwell dwell;
  Shift shift;
  Retract retract;
};

/// G74 and G84.
constexpr bool taps(const CannedCycle& cycle) {
  return cycle.dwell == CannedCycle::Dwell::BottomAndR;
}

/// The row of a code, or nullptr: G80 and every other code.
const CannedCycle* find_canned_cycle(int code);

/// I, J and K of a peck of a Haas: the first cut, how much less each next one is, and the least.
/// mm, not below 0.
struct ShrinkingPeck {
  double first = 0.0;
  double less = 0.0;
  double least = 0.0;

  bool operator==(const ShrinkingPeck&) const = default;
};

/// What a canned cycle keeps from block to block, until G80 or a code of group 01 (MB-306, MB-313).
/// Levels are coordinates along the drilling axis as programmed, mm.
struct CycleData {
  double initial = 0.0;  ///< where the axis stood before the first cycle: what G98 returns to
  double r = 0.0;
  double bottom = 0.0;
  double q = 0.0;                          ///< mm, >= 0: depth of a peck, or the shift
  std::optional<ShrinkingPeck> shrinking;  ///< in the place of Q
  double clear_after = 0.0;  ///< mm: so much deeper a peck of G73 returns to R; 0: never
  /// mm along the first and the second axis of the plane: a shift in the place of Q.
  std::optional<std::array<double, 2>> aside;
  double dwell_s = 0.0;         ///< P
  bool is_synchronous = false;  ///< ,R1 of a tapping cycle
  bool has_begun = false;       ///< its first block has run

  bool operator==(const CycleData&) const = default;
};

}  // namespace g31::fanuc

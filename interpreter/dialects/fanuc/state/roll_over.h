#pragma once

#include <array>

#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc {

/// Rotary axes that go round: parameter 1008.  Positions stay as they are, whole turns included:
/// absolute values, the way home and what variables show are taken within a turn.  Source: FANUC
/// 16i-MA operator's manual B-63534EN/02, 20.2.1 and 20.2.2; 15i connection manual B-63783EN-1/01,
/// 1.6.3: by half a turn the way is the positive one.
class RollOver {
 public:
  RollOver() = default;
  explicit RollOver(const Parameters& parameters);

  /// Whether any axis does.
  [[nodiscard]] bool is_on() const { return is_on_; }

  /// Where an absolute value sends an axis; both in the same coordinates, deg.
  [[nodiscard]] double end(int axis, double value, double now) const;
  /// The same by the shorter way in any case.
  [[nodiscard]] double nearest(int axis, double value, double now) const;
  /// A coordinate as the control shows it, deg.
  [[nodiscard]] double shown(int axis, double value) const;

  bool operator==(const RollOver&) const = default;

 private:
  enum class Way { Plain, Shorter, BySign };

  [[nodiscard]] Way way(int axis) const { return ways_[static_cast<std::size_t>(axis)]; }

  std::array<Way, kAxisCount> ways_{};
  bool is_on_ = false;
};

}  // namespace g31::fanuc

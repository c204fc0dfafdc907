#pragma once

#include <array>
#include <optional>

#include "machine/units/point.h"

namespace g31::fanuc {

/// What the blocks of G68.2 P2 (three points) or P3 (two vectors) have said so far; each says one
/// thing, by its Q.
struct PlanePoints {
  int form = 0;  ///< P; 0: nothing has begun
  /// By Q, mm: of P2 the shift in the new system and the three points, of P3 the direction of X and
  /// of Z.
  std::array<std::optional<Point>, 4> at_q;
  Point origin = Point::Zero();  ///< of P3, mm
  double turned_deg = 0.0;       ///< of P2: R

  bool operator==(const PlanePoints&) const = default;

  [[nodiscard]] bool has_begun() const { return form != 0; }
  /// P2 needs Q1 to Q3, P3 Q1 and Q2.
  [[nodiscard]] bool is_whole() const { return at_q[1] && at_q[2] && (form == 3 || at_q[3]); }
};

}  // namespace g31::fanuc

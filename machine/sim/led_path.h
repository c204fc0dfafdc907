#pragma once

#include <optional>
#include <variant>

#include "machine/port/machine_port.h"
#include "machine/sim/arc_path.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {

/// A way that is straight, or an arc, in the base coordinates of a transformation: the axes go
/// along curves.
class LedPath {
 public:
  using BasePath = std::variant<StraightPath, ArcPath>;

  /// @param base      the way in base coordinates
  /// @param q_M_from, q_M_to  its ends as axis positions, which it has exactly
  /// @param transform  not null
  LedPath(const BasePath& base, const AxisPositions& q_M_from, const AxisPositions& q_M_to,
          AxisTransformPtr transform);

  /// Both ends, machine coordinates, exactly as given.
  [[nodiscard]] const AxisPositions& from() const { return q_M_from_; }
  [[nodiscard]] const AxisPositions& to() const { return q_M_to_; }

  /// What a vector feed counts: that of the way in base coordinates.
  [[nodiscard]] double length() const;

  /// The point at a fraction 0..1 of the way in base coordinates; at both ends exactly those.
  [[nodiscard]] AxisPositions at(double fraction) const;

  /// The derivative of at() by the fraction, from differences: for speeds, not for places.
  [[nodiscard]] AxisPositions slope_at(double fraction) const;

  /// Into how many equal pieces to cut the way so that no rotary axis turns further in one than
  /// kLedPieceDeg, and arcs have kLeastArcPieces.
  [[nodiscard]] int piece_count() const;

  /// Whether the linear axes lead everywhere on the way, as far as the ends of its pieces tell.
  [[nodiscard]] bool leads() const;

 private:
  [[nodiscard]] AxisPositions base_at(double fraction) const;

  BasePath base_;
  AxisPositions q_M_from_;
  AxisPositions q_M_to_;
  AxisTransformPtr transform_;
};

/// The way of a move from a position; nullopt: no transformation leads it, or no rotary axis turns,
/// so that what is straight in base coordinates is so for the axes.
std::optional<LedPath> led_path(const AxisPositions& q_M_from, const LinearMove& move);
/// The same of an arc; nullopt: no transformation leads it.
std::optional<LedPath> led_path(const AxisPositions& q_M_from, const ArcMove& arc);

/// Speeds and travel limits of a led way are looked at in pieces so small.
inline constexpr double kLedPieceDeg = 2.0;
inline constexpr int kLeastArcPieces = 24;

}  // namespace g31::machine

#pragma once

#include <array>
#include <optional>
#include <variant>

#include "machine/port/machine_port.h"
#include "machine/sim/arc_path.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {

/// A way that is straight, or an arc, in the base coordinates of a transformation: the axes go
/// along curves.
///
/// A short way that a cubic tells within kLedErrorMm is told by it, for each point of the
/// transformation takes the time of many.
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
  /// kLedPieceDeg, nor an arc than kArcPieceDeg.
  [[nodiscard]] int piece_count() const;

  /// Whether a cubic tells it.
  [[nodiscard]] bool is_short() const { return cubic_.has_value(); }

  /// Whether the linear axes lead everywhere on the way, as far as the ends of its pieces tell.
  [[nodiscard]] bool leads() const;

 private:
  using Cubic = std::array<AxisPositions, 4>;  // by powers of the fraction

  [[nodiscard]] AxisPositions base_at(double fraction) const;
  [[nodiscard]] AxisPositions led_to(double fraction) const;
  [[nodiscard]] std::optional<Cubic> as_cubic() const;

  BasePath base_;
  AxisPositions q_M_from_;
  AxisPositions q_M_to_;
  AxisTransformPtr transform_;
  std::optional<Cubic> cubic_;
};

/// The cubic a[0] + f (a[1] + f (a[2] + f a[3])) through the points at the fractions 0, 1/3, 2/3
/// and 1.
std::array<AxisPositions, 4> cubic_through(const std::array<AxisPositions, 4>& q);
/// Where such a cubic is furthest from a quartic.
inline constexpr double kFurthestFromQuartic[] = {0.127, 0.873};

/// mm or deg: the tip that a transformation holds stays within 1e-9 mm.
inline constexpr double kLedErrorMm = 1e-10;

/// The way of a move from a position; nullopt: no transformation leads it, or no rotary axis turns,
/// so that what is straight in base coordinates is so for the axes.
std::optional<LedPath> led_path(const AxisPositions& q_M_from, const LinearMove& move);
/// The same of an arc; nullopt: no transformation leads it.
std::optional<LedPath> led_path(const AxisPositions& q_M_from, const ArcMove& arc);

/// Speeds and travel limits of a led way are looked at in pieces so small.
inline constexpr double kLedPieceDeg = 2.0;
inline constexpr double kArcPieceDeg = 15.0;

}  // namespace g31::machine

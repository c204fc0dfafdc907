#pragma once

#include <array>
#include <optional>

#include "machine/sim/motion_profile.h"
#include "machine/units/axis_positions.h"

namespace g31::machine {

/// The way of a rapid on which each axis goes on its own: all begin together, each takes the time
/// of its own profile, and the last one to arrive ends it.
///
/// Its parameter is the time, so its length() is in seconds.  Source: FANUC 30i operator's manual
/// B-63944EN/02, G00, nonlinear interpolation type positioning.
class IndependentPath {
 public:
  /// Of each axis over the length of its own way; none: it stays.
  using Profiles = std::array<std::optional<MotionProfile>, kAxisCount>;

  IndependentPath(const AxisPositions& q_M_from, const AxisPositions& q_M_to,
                  const Profiles& profiles);

  [[nodiscard]] const AxisPositions& from() const { return q_M_from_; }
  [[nodiscard]] const AxisPositions& to() const { return q_M_to_; }
  [[nodiscard]] const Profiles& profiles() const { return profiles_; }

  /// s
  [[nodiscard]] double length() const { return duration_s_; }

  /// The point after a fraction 0..1 of the time; from 1 on exactly the end.
  [[nodiscard]] AxisPositions at(double fraction) const;

  /// mm: the second derivative of the linear axes by the fraction is nowhere longer.
  [[nodiscard]] double bend() const;

  /// Into how many pieces of equal time to cut the way so that it is nowhere further than
  /// kChordErrorMm from their chords; kMostChords at most.
  [[nodiscard]] int chord_count() const;

 private:
  AxisPositions q_M_from_;
  AxisPositions q_M_to_;
  Profiles profiles_;
  double duration_s_ = 0.0;
};

/// How an IndependentPath is travelled, as MotionProfile has it for others: each second of it takes
/// a second.
class PassingTime {
 public:
  explicit PassingTime(const IndependentPath& path) : duration_s_(path.length()) {}

  [[nodiscard]] double length() const { return duration_s_; }
  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] double time_at(double distance) const { return distance; }
  [[nodiscard]] MotionPhases phases() const;

 private:
  double duration_s_;
};

}  // namespace g31::machine

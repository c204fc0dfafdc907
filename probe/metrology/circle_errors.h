#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

namespace g31::metrology {

/// Lowest and highest order of the lobes of a circle that no other error makes.
inline constexpr int kFirstLobe = 3;
inline constexpr int kLastLobe = 6;

/// An error that comes back along an axis: sine sin(2 pi x / p) + cosine cos(2 pi x / p), mm.
struct CyclicError {
  double sine = 0.0;
  double cosine = 0.0;
};

/// Way after which the cyclic error of each axis comes back, mm; nothing: it has none.
using CyclicPitches = std::array<std::optional<double>, 2>;

/// What makes a circular path what it is.  Index 0 is the first axis of the plane, 1 the second.
struct CircleErrors {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< mm
  double radius = 0.0;                               ///< mm
  std::array<double, 2> scale = {};                  ///< error by way
  double squareness = 0.0;  ///< rad; positive: the angle between the positive axes is under 90 deg
  double mismatch = 0.0;    ///< s: lag of the first axis less that of the second
  std::array<double, 2> backlash = {};  ///< mm; positive: the axis stays behind
  CyclicPitches pitches = {};
  std::array<CyclicError, 2> cyclic = {};  ///< of axes that have a pitch
  /// Form of both directions alike (ways that are not straight), where it is asked for: the radius
  /// is larger by cosine and sine parts of kFirstLobe to kLastLobe times the angle, mm.
  std::array<CyclicError, kLastLobe - kFirstLobe + 1> lobes = {};
};

}  // namespace g31::metrology

#pragma once

#include <cmath>

namespace g31::machine {

/// The place on its turn of a rotary axis, degrees, from 0 to below 360.  Less than 1e-9 degrees
/// before a whole turn is 0: so much may be left over of sums of degrees, and a turn "from there
/// on" would be a whole one.
inline double within_turn(double degrees) {
  constexpr double kTurn = 360.0;
  constexpr double kSamePlace = 1e-9;
  const double rest = degrees - kTurn * std::floor(degrees / kTurn);
  return kTurn - rest < kSamePlace ? 0.0 : rest;
}

}  // namespace g31::machine

#pragma once

#include "machine/port/way.h"
#include "probe/collision/swept_section.h"

namespace g31::probe {

/// The place after a share 0..1 of the piece between two points of a way.
inline machine::Waypoint between(const machine::Waypoint& from, const machine::Waypoint& to,
                                 double share) {
  machine::Waypoint point;
  point.fraction = machine::fraction_between(from, to, share);
  point.q_M = from.q_M + share * (to.q_M - from.q_M);
  point.tilt = turn_between(from.tilt, to.tilt, share);
  point.lean_rad = from.lean_rad + share * (to.lean_rad - from.lean_rad);
  return point;
}

/// After which share of the piece a signal goes off that is on at its start and off at its end;
/// exact to the spacing of doubles.
/// @param is_on  says of a Waypoint whether the signal is on
template <typename IsOn>
double share_to_release(const machine::Waypoint& from, const machine::Waypoint& to,
                        const IsOn& is_on) {
  // Lead from a way of a metre down to the spacing of doubles.
  constexpr int kHalvings = 60;
  double on = 0.0;
  double off = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (on + off);
    (is_on(between(from, to, middle)) ? on : off) = middle;
  }
  return off;
}

}  // namespace g31::probe

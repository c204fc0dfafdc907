#include "machine/sim/straight_path.h"

#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

double feed_length(const AxisPositions& d) {
  // hypot: a single moving axis comes out exactly, and nothing over- or underflows.
  const double linear = std::hypot(d[0], d[1], d[2]);
  if (linear >= kLeastFeedLengthMm) {
    return linear;
  }
  const double rotary = std::hypot(d[3], d[4], d[5]);
  return rotary > 0.0 ? rotary : linear;
}

}  // namespace

StraightPath::StraightPath(const AxisPositions& q_M_from, const AxisPositions& q_M_to)
    : q_M_from_(q_M_from),
      q_M_to_(q_M_to),
      displacement_(q_M_to - q_M_from),
      length_(feed_length(displacement_)) {}

AxisPositions StraightPath::at(double fraction) const {
  G31_EXPECTS(fraction >= 0.0);
  if (fraction >= 1.0) {
    return q_M_to_;
  }
  // Cannot overshoot: a fraction below 1 takes at least one spacing of doubles off the
  // displacement, whose own rounding is at most half of one.
  return q_M_from_ + fraction * displacement_;
}

}  // namespace g31::machine

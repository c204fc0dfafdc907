#include "machine/sim/straight_path.h"

#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

/// A single moving axis comes out exactly: the root of a rounded square is the number again.  hypot
/// is for what would over- or underflow.
double root_of_squares(double a, double b, double c) {
  constexpr double kSmall = 1e-280;
  constexpr double kLarge = 1e280;
  const double sum = a * a + b * b + c * c;
  return sum > kSmall && sum < kLarge ? std::sqrt(sum) : std::hypot(a, b, c);
}

double feed_length(const AxisPositions& d, double mm_per_degree) {
  const double linear = root_of_squares(d[0], d[1], d[2]);
  const bool is_linear = linear >= kLeastFeedLengthMm;
  if (is_linear && mm_per_degree == 0.0) {
    return linear;
  }
  const double rotary = root_of_squares(d[3], d[4], d[5]);
  if (rotary == 0.0) {
    return linear;
  }
  return mm_per_degree == 0.0
             ? rotary
             : root_of_squares(is_linear ? linear : 0.0, mm_per_degree * rotary, 0.0);
}

}  // namespace

[[gnu::hot]] StraightPath::StraightPath(const AxisPositions& q_M_from, const AxisPositions& q_M_to,
                                        double mm_per_degree)
    : q_M_from_(q_M_from),
      q_M_to_(q_M_to),
      displacement_(q_M_to - q_M_from),
      length_(feed_length(displacement_, mm_per_degree)) {}

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

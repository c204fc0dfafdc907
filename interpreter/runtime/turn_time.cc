#include "interpreter/runtime/turn_time.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "machine/base/contract.h"

namespace g31::runtime {

TurnTime::TurnTime(double surface_mm_min, double lowest_rev_min, double highest_rev_min)
    : per_mm_(2.0 * std::numbers::pi / surface_mm_min),
      least_(1.0 / highest_rev_min),
      most_(lowest_rev_min > 0.0 ? std::max(least_, 1.0 / lowest_rev_min)
                                 : std::numeric_limits<double>::infinity()) {
  G31_EXPECTS(surface_mm_min > 0.0);
}

double TurnTime::at(double x) const {
  return std::clamp(std::abs(x) * per_mm_, least_, most_);
}

double TurnTime::mean(double from, double to) const {
  constexpr double kSamePlaceMm = 1e-9;
  return std::abs(to - from) < kSamePlaceMm ? at(from)
                                            : (integral(to) - integral(from)) / (to - from);
}

/// Of at() from 0 to x, odd in x.
double TurnTime::integral(double x) const {
  const double t = std::abs(x) * per_mm_;
  const double bent = std::min(t, most_);
  double sum = t <= least_ ? least_ * t : (bent * bent + least_ * least_) / 2.0;
  sum += t > most_ ? most_ * (t - most_) : 0.0;
  return std::copysign(sum / per_mm_, x);
}

}  // namespace g31::runtime

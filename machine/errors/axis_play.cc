#include "machine/errors/axis_play.h"

#include <algorithm>
#include <cmath>

namespace g31::errors {

AxisPlay AxisPlay::after(double q) const {
  AxisPlay next = *this;
  const double way = q - q_;
  next.q_ = q;
  next.slack_ = std::clamp(slack_ - way, 0.0, setup_.backlash);
  if (std::abs(way) < kLeastReversal) {
    return next;
  }
  next.direction_ = std::copysign(1.0, way);
  if (next.direction_ == -direction_) {
    next.behind_at_reversal_ = -behind();
    next.way_ = 0.0;
  }
  // While the backlash is taken up the table does not move yet.
  next.way_ += std::abs(way) - std::abs(next.slack_ - slack_);
  return next;
}

double AxisPlay::offset() const {
  return slack_ - direction_ * behind();
}

double AxisPlay::behind() const {
  // exp(-30) of the spike is below any scale.
  if (setup_.spike == 0.0 || way_ > 30.0 * setup_.spike_way) {
    return 0.0;
  }
  const double w = way_ / setup_.spike_way;
  const double behind = behind_at_reversal_ * std::exp(-w) + setup_.spike * w * std::exp(1.0 - w);
  return std::min(behind, behind_at_reversal_ + way_);
}

}  // namespace g31::errors

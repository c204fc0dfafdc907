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
    next.way_ = 0.0;
  }
  next.way_ += std::abs(way);
  return next;
}

double AxisPlay::offset() const {
  // exp(-30) of the spike is below any scale.
  if (setup_.spike == 0.0 || way_ > 30.0 * setup_.spike_way) {
    return slack_;
  }
  const double w = way_ / setup_.spike_way;
  return slack_ - direction_ * std::min(way_, setup_.spike * w * std::exp(1.0 - w));
}

}  // namespace g31::errors

#pragma once

#include "machine/base/contract.h"

namespace g31::machine {

/// Simulated time since the start of the program, in seconds.
///
/// Compensated summation: after a million short blocks the sum is still right to the last digit
/// or two, so that run times can be compared between programs.
class Clock {
 public:
  /// @param seconds >= 0
  void advance(double seconds) {
    G31_EXPECTS(seconds >= 0.0);
    const double term = seconds - carry_;
    const double sum = sum_ + term;
    carry_ = (sum - sum_) - term;
    sum_ = sum;
  }

  [[nodiscard]] double now_s() const { return sum_; }

 private:
  double sum_ = 0.0;
  double carry_ = 0.0;  // what sum_ has too much by rounding
};

}  // namespace g31::machine

#pragma once

#include <string>
#include <vector>

namespace g31::plot {

/// The largest of 1, 2, 5 times a power of ten that is not above a value > 0.
double round_down(double value);

/// Round numbers within a range that divide it into about so many pieces.
struct Ticks {
  double step = 1.0;
  std::vector<double> places;
};
Ticks ticks_between(double low, double high, int pieces);

/// A number with as many decimals as a step of its scale needs; no zero has a sign.
std::string label_of(double value, double step);

/// Numbers along an axis, to pixels.
class Scale {
 public:
  /// @param from, to  pixels of low and high
  Scale(double low, double high, double from, double to);

  [[nodiscard]] double at(double value) const {
    return from_ + (value - low_) / (high_ - low_) * (to_ - from_);
  }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

 private:
  double low_;
  double high_;
  double from_;
  double to_;
};

/// Numbers of the points of a long line that show all of it: of each of 1000 stretches the first,
/// the lowest, the highest and the last, in their order.  Peaks stay.
std::vector<std::size_t> shown_points(const std::vector<double>& heights);

}  // namespace g31::plot

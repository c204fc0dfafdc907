#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g31::runtime {

/// Minutes that a turn of the spindle takes at constant surface speed, by the distance x from the
/// turning centre in mm: in proportion to |x|, between those of the highest and the lowest speed.
class TurnTime {
 public:
  /// @param surface_mm_min   > 0
  /// @param lowest_rev_min   0: as slowly as it likes
  /// @param highest_rev_min  infinity: no limit, 0: a turn never ends; it counts more than the
  /// lowest
  TurnTime(double surface_mm_min, double lowest_rev_min, double highest_rev_min);

  [[nodiscard]] double at(double x) const;

  /// Over a way on which x changes evenly, so that such a way takes its time: in closed form.
  [[nodiscard]] double mean(double from, double to) const;

 private:
  [[nodiscard]] double integral(double x) const;

  double per_mm_;
  double least_;
  double most_;
};

/// Over an arc: in chords, and in halves of them, which say what is left between chord and arc.
/// @param x_at  the distance after a share of the way, 0 to 1
template <typename Place>
double mean_over_arc(const TurnTime& time, double sweep_rad, const Place& x_at) {
  constexpr double kChordRad = std::numbers::pi / 360.0;
  const int chords = std::max(1, static_cast<int>(std::ceil(sweep_rad / kChordRad)));
  double sum = 0.0;
  double from = x_at(0.0);
  for (int i = 1; i <= chords; ++i) {
    const double between = x_at((i - 0.5) / chords);
    const double to = x_at(static_cast<double>(i) / chords);
    const double in_halves = (time.mean(from, between) + time.mean(between, to)) / 2.0;
    sum += in_halves + (in_halves - time.mean(from, to)) / 3.0;
    from = to;
  }
  return sum / chords;
}

}  // namespace g31::runtime

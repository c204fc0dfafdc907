#pragma once

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

}  // namespace g31::runtime

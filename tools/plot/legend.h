#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tools/plot/svg.h"

namespace g31::plot {

/// What stands beside a plot, row by row.
class Legend {
 public:
  /// @param left  pixels, as is the first row's height
  Legend(Svg& svg, double left, double first_row) : svg_(svg), left_(left), row_(first_row) {}

  /// A piece of a line as it is drawn, and its name.
  /// @param mark  of the dot on it; empty: none
  void line(std::string_view style, std::string_view name, std::string_view mark = {});
  /// Further down.
  void skip(double pixels) { row_ += pixels; }
  void facts(std::span<const std::string> facts);

  [[nodiscard]] double row() const { return row_; }

 private:
  Svg& svg_;
  double left_;
  double row_;
};

/// Pixels that a fact of a legend takes at most: letters and digits are taken as wide as fonts have
/// them.
double width_of(std::string_view fact);

}  // namespace g31::plot

#pragma once

#include <array>

#include "tools/plot/scale.h"
#include "tools/plot/svg.h"

namespace g31::plot {

/// Where the numbers of a plot go, pixels.
struct Frame {
  double left = 0.0;
  double right = 0.0;
  double top = 0.0;
  double bottom = 0.0;

  /// Lines at round numbers along both axes, with the numbers beside them.
  /// @param origin  what the zeros of the scales stand for
  void draw_grid(Svg& svg, const Scale& x, const Scale& y,
                 const std::array<double, 2>& origin) const;
  void draw_border(Svg& svg) const;
};

}  // namespace g31::plot

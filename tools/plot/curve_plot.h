#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/plot/growth.h"
#include "tools/plot/language.h"

namespace g31::plot {

enum class CurveStyle : std::uint8_t { Line, Dashed, Marked, DashedMarked, Dots };

/// Points in their order, joined but for Dots.
struct CurveTrace {
  std::string name;  ///< "": not in the legend
  std::vector<std::array<double, 2>> points;
  CurveStyle style = CurveStyle::Line;
  std::size_t colour = 0;          ///< 0 to 3
  std::vector<double> radii = {};  ///< px, of Dots
};

/// Curves over an axis.
struct CurvePlot {
  std::string title;
  std::string x_label;  ///< with its unit
  std::string y_label;
  std::vector<CurveTrace> traces;
  std::vector<std::string> facts;         ///< lines beside the drawing
  bool begins_at_zero = false;            ///< the upright axis
  bool has_equal_scales = false;          ///< both axes show a length alike
  Language language = Language::English;  ///< that its texts are in
  Growth growth = {};                     ///< told of the drawing as it grows
};

/// The drawing as SVG.
std::string draw(const CurvePlot& plot);

}  // namespace g31::plot

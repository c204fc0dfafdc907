#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tools/plot/growth.h"
#include "tools/plot/language.h"

namespace g31::plot {

/// A recorded path, as points and their deviations from the nominal one.
struct PathTrace {
  std::string name;                     ///< "": not in the legend
  std::vector<Eigen::Vector2d> points;  ///< mm, from the centre
  std::vector<double> deviations;       ///< mm, along the ray from the centre
  std::size_t colour = 0;               ///< 0 to 3
};

/// A path about a centre with its deviations enlarged along the rays from there, as Yatsuzaki shows
/// it: a point is drawn at the nominal distance plus the magnification times its deviation.
struct PathPlot {
  std::string title;
  std::array<std::string, 2> axes = {"X", "Y"};
  std::array<double, 2> centre = {};             ///< mm, what the numbers at the frame begin with
  std::function<double(double)> nominal_radius;  ///< mm, by the angle in rad
  std::vector<PathTrace> traces;
  bool has_rings = false;      ///< lines of the same deviation beside the nominal path
  double magnification = 0.0;  ///< 0: so that the largest deviation is a fourth of the radius
  /// Only this square of the drawing: its middle, mm, and its width; nullopt: all of it.
  std::optional<std::array<double, 3>> detail;
  std::vector<std::string> facts;         ///< lines beside the drawing
  Language language = Language::English;  ///< of what the drawing says itself
  Growth growth = {};                     ///< told of the drawing as it grows
};

/// The drawing as SVG.
std::string draw(const PathPlot& plot);

}  // namespace g31::plot

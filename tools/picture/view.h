#pragma once

#include <Eigen/Core>

#include "machine/units/point.h"

namespace g31::picture {

/// A point of a picture: pixels from its top left corner, y downwards, and the depth in mm: more is
/// nearer to the viewer.
struct Seen {
  double x = 0.0;
  double y = 0.0;
  double depth = 0.0;

  [[nodiscard]] Eigen::Vector2d place() const { return {x, y}; }
};

/// A look at the machine along parallel rays.
struct View {
  Point right = Point::UnitX();    ///< unit, machine frame: to the right in the picture
  Point up = Point::UnitY();       ///< unit, square to it
  Point towards = Point::UnitZ();  ///< unit, right x up: to the viewer
  Point p_M_middle = Point::Zero();
  double pixels_per_mm = 1.0;  ///< > 0
  int width = 1;               ///< pixels
  int height = 1;

  [[nodiscard]] Seen seen(const Point& p_M) const {
    const Point d = p_M - p_M_middle;
    return {0.5 * width + pixels_per_mm * right.dot(d), 0.5 * height - pixels_per_mm * up.dot(d),
            towards.dot(d)};
  }
  /// The same look in a picture of so many times as many pixels each way.
  [[nodiscard]] View enlarged(int times) const {
    View view = *this;
    view.pixels_per_mm *= times;
    view.width *= times;
    view.height *= times;
    return view;
  }
};

/// What is taken away so that the inside is seen: all of X above and Y below a place.
struct CutOpen {
  double x = 0.0;  ///< mm, machine frame
  double y = 0.0;

  [[nodiscard]] bool removes(const Point& p_M) const { return p_M.x() > x && p_M.y() < y; }
};

}  // namespace g31::picture

#include "interpreter/path/path_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g31::path {
namespace {

/// The direction of travel on an arc, at a point of it.
PlanePoint along_arc(const ArcShape& arc, const PlanePoint& p) {
  const PlanePoint radial = (p - arc.centre).normalized();
  return arc.turn == machine::Turn::Counterclockwise ? PlanePoint(-radial.y(), radial.x())
                                                     : PlanePoint(radial.y(), -radial.x());
}

}  // namespace

PlanePoint direction_at_start(const PlaneWay& way) {
  return way.arc ? along_arc(*way.arc, way.from) : PlanePoint((way.to - way.from).normalized());
}

PlanePoint direction_at_end(const PlaneWay& way) {
  return way.arc ? along_arc(*way.arc, way.to) : PlanePoint((way.to - way.from).normalized());
}

double sweep_rad(const PlaneWay& way) {
  constexpr double kFullRad = 2.0 * std::numbers::pi;
  if (!way.arc) {
    return 0.0;
  }
  if ((way.to - way.from).norm() < kOnePointMm) {
    return kFullRad;
  }
  const PlanePoint a = way.from - way.arc->centre;
  const PlanePoint b = way.to - way.arc->centre;
  const double left = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  const double sweep = way.arc->turn == machine::Turn::Counterclockwise ? left : -left;
  return sweep > 0.0 ? sweep : sweep + kFullRad;
}

int chords_of(double sweep_rad, double radius_mm, double error_mm) {
  constexpr double kMost = 1e7;
  // radius (1 - cos(step / 2)) = error, by the half angle, for 1 - error / radius may be 1
  const double step = 4.0 * std::asin(std::sqrt(0.5 * std::min(1.0, error_mm / radius_mm)));
  const double chords = std::ceil(std::abs(sweep_rad) / step);
  return chords >= 1.0 ? static_cast<int>(std::min(chords, kMost)) : 1;
}

}  // namespace g31::path

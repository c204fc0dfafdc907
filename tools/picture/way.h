#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "machine/units/point.h"

namespace g31::picture {

/// What kind of motion a way was.
enum class PathKind { Rapid, Feed, Skip };

inline constexpr std::size_t kPathKinds = 3;

/// What the stylus ball's centre did in one move.
struct Way {
  PathKind kind = PathKind::Rapid;
  double time_from_s = 0.0;  ///< simulated time
  double time_to_s = 0.0;    ///< not before time_from_s
  /// mm, machine frame: two or more, at equal steps of time; of a move that was broken off the last
  /// step may be shorter.
  std::vector<Point> points;
};

/// Where something was touched, wanted or not.
struct Mark {
  Point p_M = Point::Zero();   ///< mm, machine frame
  Point n_M = Point::UnitZ();  ///< unit normal of the surface there
  std::string part;
  std::string what;  ///< "stylus ball touches ring"; empty for a wanted touch
};

}  // namespace g31::picture

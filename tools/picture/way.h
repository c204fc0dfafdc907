#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "machine/units/axis_positions.h"
#include "machine/units/point.h"

namespace g31::picture {

/// What kind of motion a way was.
enum class PathKind { Rapid, Feed, Skip };

inline constexpr std::size_t kPathKinds = 3;

/// Along what the stylus ball's centre went in one move; when it is where on it, a Track says.
/// Where rotary axes turn tool and part against each other, it is told in the frame of the part, as
/// contacts are.
struct Way {
  PathKind kind = PathKind::Rapid;
  double time_from_s = 0.0;  ///< simulated time
  double time_to_s = 0.0;    ///< not before time_from_s
  /// mm, machine frame: two or more, the ends of chords to be drawn; not at equal steps of time.
  std::vector<Point> points;
  /// How what carries the ball is turned at the beginning and at the end.
  std::array<Eigen::Quaterniond, 2> turns = {Eigen::Quaterniond::Identity(),
                                             Eigen::Quaterniond::Identity()};
};

/// Where the point that ways follow stands, and how what carries it is turned there.
struct StylusPlace {
  Point p_M = Point::Zero();                                 ///< mm, machine frame
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< spindle and rotary axes
  int tool = 0;  ///< the tool whose lowest point it is; 0: the probe, or the gauge point
  AxisPositions q_M = AxisPositions::Zero();  ///< where the axes stand then
};

/// A ball of the probe, or the round end of a tool.
struct TouchingBall {
  Point p_M = Point::Zero();  ///< mm, machine frame: its centre
  double radius_mm = 0.0;     ///< > 0
};

/// Where something was touched, wanted or not.
struct Mark {
  Point p_M = Point::Zero();   ///< mm, machine frame
  Point n_M = Point::UnitZ();  ///< unit normal of the surface there, out of the material
  std::string part;
  std::string what;       ///< "stylus ball touches ring"; empty for a wanted touch
  std::size_t touch = 0;  ///< the how-manyth skip move it is of, from 1; 0: a collision
  StylusPlace stylus;     ///< as latched; of a collision where it happened
  std::optional<TouchingBall> ball = {};  ///< of the stylus there that touched; nullopt: not known
  /// Where the axes stood then, in machine coordinates; nullopt: there p_M is that.
  std::optional<Point> p_machine = {};
};

}  // namespace g31::picture

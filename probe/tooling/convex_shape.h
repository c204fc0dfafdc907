#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include <Eigen/Core>

#include "machine/units/point.h"
#include "probe/collision/probe_section.h"

namespace g31::probe {

/// A flat blade in a plane through the axis of a tool: the area between the axis and the cutting
/// edge of one tooth, with one rounded corner.
struct Blade {
  /// Distance from the axis, height; mm.
  using Radial = Eigen::Vector2d;

  Radial direction = Radial::UnitX();  ///< of its plane from the axis: X, Y of the tool
  std::array<Radial, 4> corners = {};  ///< the sharp ones, in any order
  Radial rounded_centre = Radial::Zero();
  double rounded_radius = 0.0;  ///< >= 0, of the quarter that looks outwards and down
};

/// A box about its own middle, mm.
struct Box {
  Point half = Point::Zero();
};

/// The plate of a turning tool in the plane of X and Z: a ball at its tip and the ends of its two
/// edges, with all between them.
struct InsertPlate {
  Point p_tip_centre = Point::Zero();
  double tip_radius = 0.0;  ///< >= 0
  std::array<Point, 2> edge_ends = {Point::Zero(), Point::Zero()};
};

/// The shapes whose first contact convex_cast finds.  A section counts with its rounding and at its
/// place.
using ConvexShape = std::variant<Blade, Box, ProbeSection, InsertPlate>;

/// The point of the blade in its plane that lies furthest in a direction of that plane.
/// @param asked  its share along the plane, not negative where the blade faces what is asked about
Blade::Radial furthest_of(const Blade& blade, const Blade::Radial& asked);

/// The point of the shape, in its own frame, that lies furthest in a direction.
/// @param direction  of any length but 0
Point furthest_of(const ConvexShape& shape, const Point& direction);

/// A shape where it is.
struct PlacedShape {
  const ConvexShape* shape = nullptr;  ///< not owned
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Point p = Point::Zero();

  [[nodiscard]] Point furthest(const Point& direction) const {
    return turn * furthest_of(*shape, turn.transpose() * direction) + p;
  }
};

}  // namespace g31::probe

#pragma once

#include "machine/units/point.h"
#include "probe/tooling/convex_shape.h"

namespace g31::probe {

enum class CastStatus {
  Miss,
  Contact,
  StartsInside,  ///< the shapes overlap before the way begins
};

/// Where a shape that goes along a straight way first meets another.
struct CastHit {
  CastStatus status = CastStatus::Miss;
  double fraction = 0.0;          ///< 0..1 of the way, with Contact
  Point n = Point::Zero();        ///< unit normal of the target there, towards what moves
  Point p_point = Point::Zero();  ///< where they touch, on the target
};

/// The first contact of two convex shapes, one of which goes along a straight way without turning.
///
/// After G. van den Bergen, Ray Casting against General Convex Objects with Application to
/// Continuous Collision Detection (2004): the start goes as a ray against the Minkowski difference
/// of the shapes.
/// Accuracy: kCastErrorMm against closed forms, for shapes and ways of up to 1000 mm; normals of
/// flat faces are exact to 1e-9, of others to 1e-5; the point of touch to 1e-3 mm.
/// @param way  of `moving` from its place, mm; not 0
CastHit convex_cast(const PlacedShape& target, const PlacedShape& moving, const Point& way);

inline constexpr double kCastErrorMm = 1e-8;

}  // namespace g31::probe

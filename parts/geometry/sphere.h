#pragma once

#include "machine/units/point.h"

namespace g31::parts {

/// A true sphere, mm.
struct Sphere {
  Point centre = Point::Zero();
  double radius = 0.0;  ///< > 0
};

}  // namespace g31::parts

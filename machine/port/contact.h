#pragma once

#include <string>

#include "machine/units/point.h"

namespace g31::machine {

/// Where two bodies met.
struct Contact {
  Point p_M_point;   ///< mm, machine frame: the point of touch on the part
  Point n_M;         ///< unit surface normal of the part there, pointing to the ball centre
  std::string part;  ///< name of the part from the set-up sheet
  /// The normal of the smooth surface that the facets of a mesh stand for; 0: not known.
  Point n_M_smooth = Point::Zero();
};

}  // namespace g31::machine

#pragma once

#include "machine/kinematics/axis_chain.h"
#include "machine/units/axis_positions.h"
#include "machine/units/point.h"

namespace g31::picture {

/// A place on a surface with its outward normal.
struct SurfacePlace {
  Point p;
  Point n;
};

/// A place of the machine in the frame of the part, which pictures are in; where no axis has turned
/// the part or the tool it is the same.
SurfacePlace on_part(const machine::AxisChain& chain, const AxisPositions& q_M,
                     const SurfacePlace& place_M);

}  // namespace g31::picture

#pragma once

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {

/// The plane that a cycle positions in; its third axis drills.
Plane cycle_plane(const Control& control);

/// Z, R, Q and P of a block of the cycle in force, and what its first block leaves out.  I, J and K
/// only where no other code of the block has them.
MaybeFailure take_cycle_data(Control& control, const NcBlock& block);

/// Rapid to a place of the plane, and the cycle in force there.
/// @param q_L  the drilling axis does not count
MaybeFailure drill_at(Control& control, const AxisPositions& q_L);

}  // namespace g31::fanuc

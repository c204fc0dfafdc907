#pragma once

#include <vector>

#include "machine/port/surroundings.h"
#include "machine/sim/straight_path.h"
#include "machine/sim/true_position.h"

namespace g31::machine {

/// What the tool tip really does on a straight path of the encoders: points so close that the
/// straight pieces between them stay within kTrueWayErrorMm.
std::vector<Waypoint> true_way(const TruePosition& start, const StraightPath& path);

/// The same on a curve, whose chords count as straight.
std::vector<Waypoint> true_way(const TruePosition& start, const CurvedSweep& curve);

/// A tenth of a nanometre.
inline constexpr double kTrueWayErrorMm = 1e-7;

}  // namespace g31::machine

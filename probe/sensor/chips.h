#pragma once

#include "probe/sensor/bodies.h"
#include "probe/tooling/tool_probe_setup.h"

namespace g31::probe {

/// What lies no farther than this from a plate is on it, mm.
inline constexpr double kOnPlateMm = 0.05;

/// Whether a part lies on the plate of a tool probe and hands on what touches it: any piece of its
/// surface, not only a corner, is on or in the plate.  What the plate stands on is none: its lower
/// face does not count.
bool is_chip(const ProbedPart& part, const ToolProbeSetup& setup);

}  // namespace g31::probe

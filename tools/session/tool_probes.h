#pragma once

#include <cstdint>
#include <vector>

#include "probe/sensor/bodies.h"
#include "probe/sensor/world.h"
#include "probe/tooling/tool_probe_setup.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The plates of tool probes as what the touch probe must not meet; a beam of light is none.
std::vector<probe::ProbedPart> plates_of(const std::vector<probe::ToolProbeSetup>& tool_probes);

/// Puts the tool probes of the job into a world, with all tools that the spindle may hold.
void add_tool_probes(const setup::Job& job, std::uint64_t seed, probe::World::Sets& sets);

}  // namespace g31::session

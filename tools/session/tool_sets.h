#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "probe/sensor/bodies.h"
#include "probe/sensor/cutting_tool.h"
#include "probe/sensor/world.h"
#include "probe/tooling/tool_probe_setup.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The plates of tool probes as what the touch probe must not meet; a beam of light is none.
std::vector<probe::ProbedPart> plates_of(const std::vector<probe::ToolProbeSetup>& tool_probes);

/// What the tools of the job must not meet among parts that are made already; nothing where neither
/// a tool has a holder nor a part is a fixture.
std::shared_ptr<const probe::ToolObstacles> tool_obstacles_of(
    const setup::Job& job, const std::vector<probe::ProbedPart>& parts);

/// Puts the tools that the spindle may hold into a world, and the tool probes that measure them.
/// @param obstacles  not null
void add_tools(const setup::Job& job, std::shared_ptr<const probe::ToolObstacles> obstacles,
               std::uint64_t seed, probe::World::Sets& sets);

}  // namespace g31::session

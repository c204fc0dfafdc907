#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "probe/sensor/bodies.h"
#include "probe/sensor/cutting_tool.h"
#include "probe/sensor/displacement_sensors.h"
#include "probe/sensor/world.h"
#include "probe/tooling/tool_probe_setup.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The plates of tool probes as what the touch probe must not meet; a beam of light is none.
std::vector<probe::ProbedPart> plates_of(const std::vector<probe::ToolProbeSetup>& tool_probes);

/// The beams of lasers, for pictures: nothing meets them.
std::vector<probe::ProbedPart> beams_of(const std::vector<probe::ToolProbeSetup>& tool_probes);

/// What parts are to tools, with what takes long to make; may be shared by threads.
struct ToolParts {
  /// Of what does not go its own way (CarriedParts).  Empty where neither a tool has a holder nor a
  /// part is a fixture.
  std::shared_ptr<const probe::ToolObstacles> obstacles;
  /// Of each tool probe the parts that lie on its plate (chips.h).
  std::vector<std::vector<probe::CollisionMesh>> chips;
};

/// Whether any part is more to a tool than what it cuts: its meshes are wanted then.
bool do_parts_matter(const setup::Job& job, const std::vector<probe::ProbedPart>& parts);

/// Of parts that are made already.
/// @param meshes  of the same parts; empty where they do not matter
std::shared_ptr<const ToolParts> tool_parts_of(const setup::Job& job,
                                               const std::vector<probe::ProbedPart>& parts,
                                               const probe::SeenParts& meshes);

/// What the tools that the spindle may hold meet among those obstacles.
std::unique_ptr<machine::Surroundings> tools_among(
    const setup::Job& job, const std::shared_ptr<const probe::ToolObstacles>& obstacles);

/// Puts the tools that the spindle may hold into a world, and the tool probes that measure them.
/// @param parts  of the same job
void add_tools(const setup::Job& job, const ToolParts& parts, std::uint64_t seed,
               probe::World::Sets& sets);

}  // namespace g31::session

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "parts/geometry/mesh.h"
#include "tools/session/world.h"
#include "tools/setup/job.h"

namespace g31::picture {

/// A part where it stands.
struct PicturedPart {
  std::string name;
  std::shared_ptr<const parts::Mesh> mesh_M;  ///< not null; where no axis moved it, the world's own
  bool is_fixture = false;  ///< a vice, a clamp, the plate of a tool probe: not what is measured
};

/// The parts of a world, in its order, and the beams of its tool probes, in the frame of the part:
/// what axes carry stands where they have brought it.
/// @param world  outlives them
/// @param job    of that world
/// @param q_M    where the axes stand
std::vector<PicturedPart> parts_of(const session::World& world, const setup::Job& job,
                                   const AxisPositions& q_M);

}  // namespace g31::picture

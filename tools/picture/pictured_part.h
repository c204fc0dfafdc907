#pragma once

#include <string>
#include <vector>

#include "parts/geometry/mesh.h"
#include "tools/session/world.h"

namespace g31::picture {

/// A part where it stands; the mesh belongs to somebody else.
struct PicturedPart {
  std::string name;
  const parts::Mesh* mesh_M = nullptr;
  bool is_fixture = false;  ///< a vice, a clamp, the plate of a tool probe: not what is measured
};

/// The parts of a world, in its order, and the beams of its tool probes.  @param world  outlives
/// them
std::vector<PicturedPart> parts_of(const session::World& world);

}  // namespace g31::picture

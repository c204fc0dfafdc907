#include "tools/picture/pictured_part.h"

namespace g31::picture {

std::vector<PicturedPart> parts_of(const session::World& world) {
  std::vector<PicturedPart> parts;
  for (const probe::ProbedPart& part : world.parts) {
    parts.push_back({part.name, &part.mesh_M, part.role != probe::Role::Part});
  }
  return parts;
}

}  // namespace g31::picture

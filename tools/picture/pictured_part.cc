#include "tools/picture/pictured_part.h"

namespace g31::picture {

std::vector<PicturedPart> parts_of(const session::World& world) {
  std::vector<PicturedPart> parts;
  for (const auto* const drawn : {&world.parts, &world.beams}) {
    for (const probe::ProbedPart& part : *drawn) {
      parts.push_back({part.name, &part.mesh_M, part.role != probe::Role::Part});
    }
  }
  return parts;
}

}  // namespace g31::picture

#include "tools/picture/pictured_part.h"

#include "tools/session/carried_parts.h"

namespace g31::picture {
namespace {

std::shared_ptr<const parts::Mesh> standing_mesh(const probe::ProbedPart& part,
                                                 const setup::Job& job, const AxisPositions& q_M) {
  const auto carrier = session::carrier_of(job, part);
  if (!carrier) {
    return {std::shared_ptr<const void>(), &part.mesh_M};
  }
  const Eigen::Isometry3d part_from_carrier = probe::part_from(*carrier, q_M);
  parts::Mesh mesh = part.mesh_M;
  for (Point& p : mesh.vertices) {
    p = part_from_carrier * p;
  }
  return std::make_shared<const parts::Mesh>(std::move(mesh));
}

}  // namespace

std::vector<PicturedPart> parts_of(const session::World& world, const setup::Job& job,
                                   const AxisPositions& q_M) {
  std::vector<PicturedPart> parts;
  for (const auto* const drawn : {&world.parts, &world.beams}) {
    for (const probe::ProbedPart& part : *drawn) {
      parts.push_back({part.name, standing_mesh(part, job, q_M), part.role != probe::Role::Part});
    }
  }
  return parts;
}

}  // namespace g31::picture

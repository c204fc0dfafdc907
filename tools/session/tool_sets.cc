#include "tools/session/tool_sets.h"

#include <algorithm>
#include <utility>

#include "machine/base/contract.h"
#include "parts/artefacts/artefact.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/tool_probe.h"

namespace g31::session {
namespace {

/// Standing in the sheet's place with its upper face.
parts::PartSetup plate_shape(const probe::ToolProbeSetup& setup) {
  parts::PartSetup plate;
  plate.name = setup.name;
  const auto& [first, second, third] = setup.size_mm;
  if (setup.shape == probe::ToolProbeShape::Disc) {
    plate.shape = "cylinder";
    plate.sizes = {{"diameter", first}, {"height", second}};
  } else {
    plate.shape = "block";
    plate.sizes = {{"length", first}, {"width", second}, {"height", third}};
  }
  return plate;
}

probe::UnnamedTools unnamed_tools(const setup::Job& job) {
  const bool stays = job.probe && !job.probe->switching.tool;
  return stays ? probe::UnnamedTools::TouchProbe : probe::UnnamedTools::Believed;
}

}  // namespace

std::vector<probe::ProbedPart> plates_of(const std::vector<probe::ToolProbeSetup>& tool_probes) {
  std::vector<probe::ProbedPart> plates;
  for (const probe::ToolProbeSetup& setup : tool_probes) {
    if (setup.shape == probe::ToolProbeShape::Laser) {
      continue;
    }
    const auto mesh_P = parts::make_artefact(plate_shape(setup));
    G31_EXPECTS(mesh_P.ok());
    const parts::Placement place{setup.p_M_at, setup.rotate_deg};
    plates.push_back({setup.name, parts::placed_mesh(mesh_P.value(), place)});
    plates.back().role = probe::Role::SensingTarget;
    plates.back().mount =
        setup.side == probe::ToolProbeSide::Bed ? probe::Mount::Bed : probe::Mount::Table;
  }
  return plates;
}

std::shared_ptr<const probe::ToolObstacles> tool_obstacles_of(
    const setup::Job& job, const std::vector<probe::ProbedPart>& parts) {
  const bool has_fixture =
      std::ranges::find(parts, probe::Role::Rigid, &probe::ProbedPart::role) != parts.end();
  const auto has_holder = [](const probe::ToolSetup& tool) { return !tool.bodies.empty(); };
  const bool matters = has_fixture || std::ranges::any_of(job.tools, has_holder);
  return std::make_shared<const probe::ToolObstacles>(matters ? parts
                                                              : std::vector<probe::ProbedPart>());
}

void add_tools(const setup::Job& job, std::shared_ptr<const probe::ToolObstacles> obstacles,
               std::uint64_t seed, probe::World::Sets& sets) {
  const auto number = job.probe ? job.probe->switching.tool : std::nullopt;
  const auto rack = std::make_shared<const probe::ToolRack>(job.tools, number, unnamed_tools(job));
  sets.push_back(std::make_unique<probe::CuttingTool>(std::move(obstacles), rack));
  for (std::size_t i = 0; i < job.tool_probes.size(); ++i) {
    sets.push_back(std::make_unique<probe::ToolProbe>(job.tool_probes[i], rack, seed,
                                                      static_cast<std::uint32_t>(i)));
  }
}

}  // namespace g31::session

#include "tools/session/tool_sets.h"

#include <algorithm>
#include <utility>

#include "machine/base/contract.h"
#include "parts/artefacts/artefact.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/chips.h"
#include "probe/sensor/tool_probe.h"
#include "tools/session/carried_parts.h"

namespace g31::session {
namespace {

/// Standing in the sheet's place with its upper face.
parts::PartSetup plate_shape(const probe::ToolProbeSetup& setup) {
  const Point extent = extent_mm(setup);
  parts::PartSetup plate;
  plate.name = setup.name;
  plate.sizes["height"] = extent.z();
  if (setup.shape == probe::ToolProbeShape::Disc) {
    plate.shape = "cylinder";
    plate.sizes["diameter"] = extent.x();
  } else {
    plate.shape = "block";
    plate.sizes["length"] = extent.x();
    plate.sizes["width"] = extent.y();
  }
  return plate;
}

/// Along X, its middle in the origin.
parts::Mesh beam_mesh(const probe::ToolProbeSetup& setup) {
  const Point extent = extent_mm(setup);
  parts::PartSetup cylinder;
  cylinder.name = setup.name;
  cylinder.shape = "cylinder";
  cylinder.sizes = {{"diameter", extent.y()}, {"height", extent.x()}};
  const auto upright = parts::make_artefact(cylinder);
  G31_EXPECTS(upright.ok());
  parts::Mesh beam = upright.value();
  for (Point& p : beam.vertices) {
    p = Point(p.z() + 0.5 * extent.x(), p.y(), -p.x());
  }
  return beam;
}

probe::Mount mount_of(const probe::ToolProbeSetup& setup) {
  return setup.side == probe::ToolProbeSide::Bed ? probe::Mount::Bed : probe::Mount::Table;
}

/// What moves the part past a probe that stands on the bed.
std::optional<probe::Carrier> carrier_of_probe(const setup::Job& job,
                                               const probe::ToolProbeSetup& setup) {
  probe::ProbedPart plate;
  plate.mount = mount_of(setup);
  return carrier_of(job, plate);
}

probe::UnnamedTools unnamed_tools(const setup::Job& job) {
  const bool stays = job.probe && !job.probe->switching.tool;
  return stays ? probe::UnnamedTools::TouchProbe : probe::UnnamedTools::Believed;
}

std::shared_ptr<const probe::ToolRack> rack_of(const setup::Job& job) {
  const auto number = job.probe ? job.probe->switching.tool : std::nullopt;
  return std::make_shared<const probe::ToolRack>(job.tools, number, unnamed_tools(job));
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
    plates.back().mount = mount_of(setup);
  }
  return plates;
}

std::vector<probe::ProbedPart> beams_of(const std::vector<probe::ToolProbeSetup>& tool_probes) {
  std::vector<probe::ProbedPart> beams;
  for (const probe::ToolProbeSetup& setup : tool_probes) {
    if (setup.shape == probe::ToolProbeShape::Laser) {
      const parts::Placement place{setup.p_M_at, setup.rotate_deg};
      beams.push_back({setup.name, parts::placed_mesh(beam_mesh(setup), place)});
      beams.back().role = probe::Role::SensingTarget;
      beams.back().mount = mount_of(setup);
    }
  }
  return beams;
}

bool do_parts_matter(const setup::Job& job, const std::vector<probe::ProbedPart>& parts) {
  const auto has_holder = [](const probe::ToolSetup& tool) { return !tool.bodies.empty(); };
  const auto matters = [&](const probe::ProbedPart& part) {
    return part.role == probe::Role::Rigid ||
           std::ranges::any_of(job.tool_probes, [&](const probe::ToolProbeSetup& setup) {
             return probe::is_chip(part, setup);
           });
  };
  return std::ranges::any_of(job.tools, has_holder) || std::ranges::any_of(parts, matters);
}

std::shared_ptr<const ToolParts> tool_parts_of(const setup::Job& job,
                                               const std::vector<probe::ProbedPart>& parts,
                                               const probe::SeenParts& meshes) {
  G31_EXPECTS(meshes.empty() || meshes.size() == parts.size());
  const std::vector<probe::CollisionMesh> solids(meshes.begin(), meshes.end());
  auto made = std::make_shared<ToolParts>();
  auto obstacles = std::make_shared<probe::ToolObstacles>();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    if (!carrier_of(job, parts[i])) {
      obstacles->add(parts[i], solids[i]);
    }
  }
  made->obstacles = std::move(obstacles);
  for (const probe::ToolProbeSetup& setup : job.tool_probes) {
    std::vector<probe::CollisionMesh>& chips = made->chips.emplace_back();
    for (std::size_t i = 0; i < solids.size(); ++i) {
      if (probe::is_chip(parts[i], setup)) {
        chips.push_back(solids[i]);
      }
    }
  }
  return made;
}

std::unique_ptr<machine::Surroundings> tools_among(
    const setup::Job& job, const std::shared_ptr<const probe::ToolObstacles>& obstacles) {
  return std::make_unique<probe::CuttingTool>(obstacles, rack_of(job));
}

void add_tools(const setup::Job& job, const ToolParts& parts, std::uint64_t seed,
               probe::World::Sets& sets) {
  G31_EXPECTS(parts.chips.size() == job.tool_probes.size());
  const auto rack = rack_of(job);
  sets.push_back(std::make_unique<probe::CuttingTool>(parts.obstacles, rack));
  for (std::size_t i = 0; i < job.tool_probes.size(); ++i) {
    sets.push_back(std::make_unique<probe::ToolProbe>(
        job.tool_probes[i], rack, seed, static_cast<std::uint32_t>(i),
        probe::ToolProbePlace{parts.chips[i], carrier_of_probe(job, job.tool_probes[i])}));
  }
}

}  // namespace g31::session

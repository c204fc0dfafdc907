#include "tools/session/world.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "parts/artefacts/artefact.h"
#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh_defects.h"
#include "parts/geometry/placement.h"
#include "parts/import/mesh_file.h"
#include "parts/import/step_file.h"
#include "probe/sensor/carrier_view.h"
#include "probe/sensor/scripted_signals.h"
#include "probe/sensor/second_probe.h"
#include "probe/sensor/touch_probe.h"
#include "probe/sensor/world.h"
#include "tools/session/tool_sets.h"
#include "tools/session/work_on_meshes.h"

namespace g31::session {
namespace {

/// Of a comment, in bytes.
constexpr std::size_t kShownComment = 60;

/// Parts the random numbers of the second probe from those of the first.
constexpr std::uint64_t kSecondProbe = 0x5345434F4E44ULL;

Refusal unusable(const source::ShownPlace& place, const std::string& why) {
  return {Ending::Setup, {}, {error_at(place, setup::SetupErrorId::PartUnusable, {why})}};
}

/// What of a mesh nobody has looked at; "": nothing.
std::string left_out(const parts::MeshDefects& defects) {
  std::string text;
  if (defects.facets_not_searched > 0) {
    text = fmt::format("{} facets were not searched for others that they go through",
                       defects.facets_not_searched);
  }
  if (defects.shells_not_placed > 0) {
    text += fmt::format("{}{} pieces were not asked which of them are inside others",
                        text.empty() ? "" : ", ", defects.shells_not_placed);
  }
  return text;
}

/// One more finding about a part.
void tell(source::DiagnosticId id, const std::string& what, const source::ShownPlace& place,
          std::vector<source::Diagnostic>& findings) {
  findings.push_back(source::make_diagnostic(id, {}, what));
  findings.back().in_sheet = place;
}

/// What is wrong with a mesh, in the words of a run.
void add_findings(const parts::Mesh& mesh_P, const parts::PartSetup& part,
                  const source::ShownPlace& place, const parts::GoesOn& goes_on,
                  std::vector<source::Diagnostic>& findings) {
  const parts::MeshDefects defects = parts::defects_of(mesh_P, goes_on);
  const auto add = [&](source::DiagnosticId id, const parts::Defect& defect) {
    if (defect.count > 0) {
      const Point& p = defect.p_P_first;
      // + 0.0: no -0 among the coordinates.
      const auto rounded = [](double mm) { return std::round(1000.0 * mm) / 1000.0 + 0.0; };
      tell(id,
           fmt::format(": {} of '{}', first at X{} Y{} Z{} in its file", defect.count, part.name,
                       rounded(p.x()), rounded(p.y()), rounded(p.z())),
           place, findings);
    }
  };
  add(source::DiagnosticId::MeshOpen, defects.open_edges);
  add(source::DiagnosticId::MeshFlipped, defects.flipped_facets);
  add(source::DiagnosticId::MeshInward, defects.inward_shells);
  add(source::DiagnosticId::MeshStray, defects.stray_shells);
  add(source::DiagnosticId::MeshSelfContact, defects.self_contacts);
  if (!parts::is_step_file(part.file)) {  // those of such a file are of our own making
    add(source::DiagnosticId::MeshFlat, defects.flat_facets);
  }
  if (const std::string left = left_out(defects); !left.empty()) {
    tell(source::DiagnosticId::MeshNotJudged, fmt::format(": of '{}' {}", part.name, left), place,
         findings);
  }
}

/// Of a file whose coordinates are rounded by more than a measurement would show.
void add_rounding(const parts::Mesh& mesh_P, const std::string& part,
                  const source::ShownPlace& place, std::vector<source::Diagnostic>& findings) {
  constexpr double kToldMm = 0.0003;
  if (mesh_P.rounding_mm > kToldMm) {
    tell(source::DiagnosticId::MeshCoarse,
         fmt::format(": coordinates of '{}' are off by up to {:.2g} mm", part, mesh_P.rounding_mm),
         place, findings);
  }
}

/// Of a file that has surfaces beside its bodies.
void add_left_out(const parts::Mesh& mesh_P, const std::string& part,
                  const source::ShownPlace& place, std::vector<source::Diagnostic>& findings) {
  if (mesh_P.faces_left_out > 0) {
    tell(
        source::DiagnosticId::FacesLeftOut,
        fmt::format(": {} of the faces in the file of '{}' {} to no solid and no closed shell",
                    mesh_P.faces_left_out, part, mesh_P.faces_left_out == 1 ? "belongs" : "belong"),
        place, findings);
  }
}

/// Adds a part of the sheet to those that are made.  @returns why it cannot be made or read
/// @throws parts::BrokenOff
std::optional<Refusal> add_part(const setup::Job& job, std::size_t which,
                                const parts::GoesOn& goes_on, BuiltParts& built) {
  const parts::PartSetup& part = job.parts[which];
  const source::ShownPlace& in_sheet = job.part_places[which];
  const auto mesh_P =
      part.shape.empty()
          ? parts::read_mesh_file(part.file, {part.step_sagitta_mm, part.unit, part.scale, goes_on})
          : parts::make_artefact(part);
  if (!mesh_P) {
    return unusable(in_sheet, mesh_P.error());
  }
  if (part.shape.empty() && part.is_closed) {
    add_findings(mesh_P.value(), part, in_sheet, goes_on, built.findings);
  }
  add_rounding(mesh_P.value(), part.name, in_sheet, built.findings);
  add_left_out(mesh_P.value(), part.name, in_sheet, built.findings);
  const parts::Placement place{part.p_M_at, part.rotate_deg, part.growth.per_unit()};
  built.parts.push_back({part.name, parts::placed_mesh(mesh_P.value(), place)});
  built.parts.back().is_solid = part.is_closed;
  if (const auto sphere_P = parts::exact_sphere(part)) {
    built.parts.back().sphere_M = parts::placed_sphere(*sphere_P, place);
  }
  built.parts.back().role = part.is_fixture ? probe::Role::Rigid : probe::Role::Part;
  mount(built.parts.back(), part, job);
  parts::Steps(goes_on).ask();
  return std::nullopt;
}

Point tip_of(const probe::ProbeSetup& setup) {
  return {setup.eccentricity_mm[0], setup.eccentricity_mm[1], -setup.length_mm};
}

std::unique_ptr<machine::Surroundings> second_probe_of(
    const setup::Job& job, std::shared_ptr<const probe::TouchableParts> parts, std::uint64_t seed) {
  const probe::SecondProbeSetup& second = *job.second_probe;
  return std::make_unique<probe::SecondProbe>(
      std::make_unique<probe::TouchProbe>(std::move(parts), second.probe, seed ^ kSecondProbe),
      probe::SecondProbe::Place{second.p_T_beside, tip_of(*job.probe), tip_of(second.probe)});
}

/// What is met of the parts on one carrier, by each of what the machine leads.
void add_carried(const setup::Job& job, const CarriedParts& group, std::uint64_t seed,
                 probe::World::Sets& sets) {
  const probe::CarriedObstacles::Place place{{chain_of(job), group.link}, group.reach_mm};
  const auto add = [&](std::unique_ptr<machine::Surroundings> inner, const auto& at) {
    sets.push_back(std::make_unique<probe::CarriedObstacles>(std::move(inner), at));
  };
  if (group.by_balls != nullptr) {
    add(std::make_unique<probe::TouchProbe>(group.by_balls, *job.probe, seed), place);
  }
  if (group.by_second != nullptr) {
    probe::CarriedObstacles::Place led = place;
    led.p_T_led = tip_of(*job.probe);
    add(second_probe_of(job, group.by_second, seed), led);
  }
  if (group.by_tools != nullptr) {
    add(tools_among(job, group.by_tools), place);
  }
}

}  // namespace

Result<BuiltParts, Refusal> build_parts(const setup::Job& job, const runtime::TimeBudget* time) {
  BuiltParts built;
  if (job.skip_signals && job.sensors.empty()) {
    return built;
  }
  const parts::GoesOn goes_on = goes_on_within(time);
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    try {
      if (auto refusal = add_part(job, i, goes_on, built)) {
        return *std::move(refusal);
      }
    } catch (const parts::BrokenOff&) {
      return too_late(*time, fmt::format("the reading of part {}", job.parts[i].name));
    }
  }
  std::ranges::move(plates_of(job.tool_probes), std::back_inserter(built.parts));
  return built;
}

std::unique_ptr<machine::Surroundings> surroundings_of(const setup::Job& job,
                                                       const SensedParts& parts,
                                                       std::uint64_t seed) {
  probe::World::Sets sets;
  const bool is_called = job.probe && job.probe->switching.tool;
  const probe::Tools tools =
      parts.by_tools || is_called ? probe::Tools::Changing : probe::Tools::Fixed;
  if (job.skip_signals) {
    sets.push_back(std::make_unique<probe::ScriptedSignals>(*job.skip_signals));
  } else if (job.probe) {
    sets.push_back(std::make_unique<probe::TouchProbe>(parts.by_balls, *job.probe, seed));
    if (parts.by_second != nullptr) {
      sets.push_back(second_probe_of(job, parts.by_second, seed));
    }
  } else if (job.sensors.empty() && !parts.by_tools) {
    return nullptr;
  }
  if (parts.by_tools) {
    add_tools(job, *parts.by_tools, seed, sets);
  }
  for (const CarriedParts& group : parts.carried) {
    add_carried(job, group, seed, sets);
  }
  auto sensors = job.sensors.empty() ? nullptr
                                     : std::make_unique<probe::DisplacementSensors>(
                                           job.sensors, parts.by_sensors, seed);
  return std::make_unique<probe::World>(std::move(sets), tools, std::move(sensors));
}

std::vector<source::Diagnostic> lost_variables(const setup::Job& job) {
  std::vector<source::Diagnostic> findings;
  for (const source::ShownPlace& place : job.lost_variables) {
    const std::string& line = place.text;
    findings.push_back(source::make_diagnostic(
        source::DiagnosticId::SettingInComment, {},
        source::printable(line.substr(std::min(line.find('#'), line.size()), kShownComment))));
    findings.back().in_sheet = place;
  }
  return findings;
}

std::optional<source::Diagnostic> start_inside(const setup::Job& job,
                                               const machine::MachiningCentre& machine) {
  const std::string name = machine.stands_inside();
  if (name.empty()) {
    return std::nullopt;
  }
  source::Diagnostic finding = source::make_diagnostic(source::DiagnosticId::StartInside, {},
                                                       fmt::format(" at the start: in '{}'", name));
  const auto part = std::ranges::find(job.parts, name, &parts::PartSetup::name);
  if (part != job.parts.end()) {
    finding.in_sheet = job.part_places[static_cast<std::size_t>(part - job.parts.begin())];
  }
  return finding;
}

Result<World, Refusal> build_world(const setup::Job& job, std::uint64_t seed,
                                   runtime::TimeBudget* time, const BuiltParts* made) {
  const auto parts = made != nullptr ? *made : build_parts(job, time);
  if (!parts) {
    return parts.error();
  }
  World world;
  world.parts = parts.value().parts;
  world.beams = beams_of(job.tool_probes);
  world.findings = parts.value().findings;
  const auto sensed = sensed_parts(job, world.parts, time);
  if (!sensed) {
    return sensed.error();
  }
  world.surroundings = surroundings_of(job, sensed.value(), seed);
  world.machine = std::make_unique<machine::MachiningCentre>(job.machine, world.surroundings.get());
  if (time != nullptr) {
    world.machine->watch(*time);
  }
  std::ranges::move(lost_variables(job), std::back_inserter(world.findings));
  if (auto inside = start_inside(job, *world.machine)) {
    world.findings.push_back(std::move(*inside));
  }
  return world;
}

}  // namespace g31::session

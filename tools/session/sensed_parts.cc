#include "tools/session/sensed_parts.h"

#include <utility>

#include "parts/geometry/goes_on.h"
#include "tools/session/work_on_meshes.h"

namespace g31::session {
namespace {

std::vector<probe::ProbedPart> chosen(const std::vector<probe::ProbedPart>& parts,
                                      const std::vector<std::size_t>& which) {
  std::vector<probe::ProbedPart> some;
  some.reserve(which.size());
  for (const std::size_t i : which) {
    some.push_back(parts[i]);
  }
  return some;
}

/// Those that go along with the table.
std::vector<std::size_t> on_table(const setup::Job& job,
                                  const std::vector<probe::ProbedPart>& parts) {
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!carrier_of(job, parts[i])) {
      which.push_back(i);
    }
  }
  return which;
}

/// Makes what probes meet of some of the parts.
struct MadeForBalls {
  std::shared_ptr<const probe::TouchableParts> by_balls;
  std::shared_ptr<const probe::TouchableParts> by_second;
};
MadeForBalls for_balls(const setup::Job& job, const std::vector<probe::ProbedPart>& parts,
                       const std::vector<std::size_t>& which, const parts::GoesOn& goes_on) {
  if (!job.probe || job.skip_signals) {
    return {};
  }
  const std::vector<probe::ProbedPart> some = chosen(parts, which);
  MadeForBalls made;
  made.by_balls = std::make_shared<const probe::TouchableParts>(*job.probe, some, goes_on);
  if (const auto& second = job.second_probe) {
    made.by_second = std::make_shared<const probe::TouchableParts>(second->probe, some, goes_on);
  }
  return made;
}

/// The meshes of all parts in their order, as the probe has them already.
probe::SeenParts seen_with(const setup::Job& job, const std::vector<probe::ProbedPart>& parts,
                           const SensedParts& sensed) {
  probe::SeenParts seen(parts.size());
  const auto take = [&](const std::vector<std::size_t>& which, const auto& touchable) {
    for (std::size_t i = 0; i < which.size(); ++i) {
      seen[which[i]] = touchable->parts().at(i).mesh;
    }
  };
  take(on_table(job, parts), sensed.by_balls);
  for (const CarriedParts& group : sensed.carried) {
    take(group.which, group.by_balls);
  }
  return seen;
}

probe::SeenParts seen_alone(const std::vector<probe::ProbedPart>& parts,
                            const parts::GoesOn& goes_on) {
  probe::SeenParts seen;
  for (const probe::ProbedPart& part : parts) {
    seen.push_back(std::make_shared<const probe::ContactMesh>(part.mesh_M, part.sphere_M, goes_on));
  }
  return seen;
}

/// Whether the sheet says what the spindle may hold, or what measures it.
bool has_tools_or_tool_probes(const setup::Job& job) {
  return !job.tools.empty() || !job.tool_probes.empty();
}

/// What no axis carries away from where sensors look for it.
probe::SeenParts seen_by_sensors(const std::vector<probe::ProbedPart>& parts,
                                 const probe::SeenParts& meshes) {
  probe::SeenParts seen;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].mount != probe::Mount::Link) {
      seen.push_back(meshes[i]);
    }
  }
  return seen;
}

/// What tools meet of the parts on a carrier.
std::shared_ptr<const probe::ToolObstacles> obstacles_of(
    const std::vector<probe::ProbedPart>& parts, const std::vector<std::size_t>& which,
    const probe::SeenParts& meshes) {
  auto obstacles = std::make_shared<probe::ToolObstacles>();
  for (const std::size_t i : which) {
    obstacles->add(parts[i], probe::CollisionMesh(meshes[i]));
  }
  return obstacles;
}

SensedParts sensed_within(const setup::Job& job, const std::vector<probe::ProbedPart>& parts,
                          const parts::GoesOn& goes_on) {
  SensedParts sensed;
  MadeForBalls made = for_balls(job, parts, on_table(job, parts), goes_on);
  sensed.by_balls = std::move(made.by_balls);
  sensed.by_second = std::move(made.by_second);
  sensed.carried = carried_parts(job, parts);
  for (CarriedParts& group : sensed.carried) {
    MadeForBalls of_group = for_balls(job, parts, group.which, goes_on);
    group.by_balls = std::move(of_group.by_balls);
    group.by_second = std::move(of_group.by_second);
  }
  const bool has_tools = !job.skip_signals && has_tools_or_tool_probes(job);
  const bool for_tools = has_tools && do_parts_matter(job, parts);
  probe::SeenParts meshes;
  if (!job.sensors.empty() || for_tools) {
    meshes = sensed.by_balls ? seen_with(job, parts, sensed) : seen_alone(parts, goes_on);
  }
  if (has_tools) {
    sensed.by_tools = tool_parts_of(job, parts, for_tools ? meshes : probe::SeenParts());
  }
  if (for_tools) {
    for (CarriedParts& group : sensed.carried) {
      group.by_tools = obstacles_of(parts, group.which, meshes);
    }
  }
  if (!job.sensors.empty()) {
    sensed.by_sensors = std::make_shared<const probe::SeenParts>(seen_by_sensors(parts, meshes));
  }
  return sensed;
}

}  // namespace

Result<SensedParts, Refusal> sensed_parts(const setup::Job& job,
                                          const std::vector<probe::ProbedPart>& parts,
                                          const runtime::TimeBudget* time) {
  try {
    return sensed_within(job, parts, goes_on_within(time));
  } catch (const parts::BrokenOff&) {
    return too_late(*time, "the trees over the parts");
  }
}

}  // namespace g31::session

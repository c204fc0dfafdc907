#include "tools/session/carried_parts.h"

#include <algorithm>
#include <string_view>

#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"

namespace g31::session {
namespace {

/// How far anything of a part is from a rotary axis at most, all axes standing at 0.
double reach_of_body(const setup::Job& job, const probe::ProbedPart& part) {
  double reach_mm = 0.0;
  for (const char axis : job.machine.chain.table_side + job.machine.chain.tool_side) {
    const int index = axis_index(axis);
    if (!is_rotary_axis(index)) {
      continue;
    }
    const Point& p_M_centre =
        job.machine.chain.rotary.at(static_cast<std::size_t>(index - kLinearAxisCount)).p_M_centre;
    for (const Point& p : part.mesh_M.vertices) {
      reach_mm = std::max(reach_mm, (p - p_M_centre).norm());
    }
  }
  return reach_mm;
}

}  // namespace

machine::AxisChain chain_of(const setup::Job& job) {
  return {job.machine.chain, Point::Zero()};
}

void mount(probe::ProbedPart& part, const parts::PartSetup& setup, const setup::Job& job) {
  if (setup.mount == parts::kTableMount) {
    return;
  }
  const machine::AxisChainSetup& chain = job.machine.chain;
  const auto link = setup.mount == parts::kBedMount
                        ? std::optional(machine::link_of_bed(chain))
                        : machine::link_on_axis(chain, setup.mount.front());
  G31_EXPECTS(link.has_value());
  part.mount = *link == 0 ? probe::Mount::Table : probe::Mount::Link;
  part.link = *link;
}

std::optional<probe::Carrier> carrier_of(const setup::Job& job, const probe::ProbedPart& part) {
  const machine::AxisChain chain = chain_of(job);
  if (part.mount == probe::Mount::Link) {
    return probe::Carrier{chain, part.link};
  }
  return part.mount == probe::Mount::Bed && chain.has_rotary_axes()
             ? std::optional(probe::Carrier{chain, std::nullopt})
             : std::nullopt;
}

std::vector<CarriedParts> carried_parts(const setup::Job& job,
                                        const std::vector<probe::ProbedPart>& parts) {
  std::vector<CarriedParts> carried;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto carrier = carrier_of(job, parts[i]);
    if (!carrier) {
      continue;
    }
    auto group = std::ranges::find(carried, carrier->link, &CarriedParts::link);
    if (group == carried.end()) {
      group = carried.insert(carried.end(), CarriedParts{carrier->link, {}, 0.0, {}, {}, {}});
    }
    group->which.push_back(i);
    group->reach_mm = std::max(group->reach_mm, reach_of_body(job, parts[i]));
  }
  return carried;
}

}  // namespace g31::session

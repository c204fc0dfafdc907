#include "tools/picture/tip.h"

#include <variant>

#include "probe/tooling/tool_shape.h"

namespace g31::picture {

Point tip_of(const setup::Job& job) {
  if (!job.probe) {
    return Point::Zero();
  }
  const auto& [x, y] = job.probe->eccentricity_mm;
  return {x, y, -job.probe->length_mm};
}

Point tip_of(const probe::ToolSetup& tool) {
  const probe::ToolShape shape = probe::shape_of(tool);
  return tool.kind == probe::ToolKind::Turning
             ? std::get<probe::ProbeSection>(shape.envelope.front()).p_S
             : shape.p_T_tip;
}

}  // namespace g31::picture

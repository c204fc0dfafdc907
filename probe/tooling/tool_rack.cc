#include "probe/tooling/tool_rack.h"

#include <algorithm>
#include <cmath>

namespace g31::probe {
namespace {

std::shared_ptr<const HeldTool> held(const ToolSetup& tool) {
  return std::make_shared<const HeldTool>(HeldTool{tool, shape_of(tool)});
}

}  // namespace

ToolRack::ToolRack(const std::vector<ToolSetup>& tools, std::optional<int> probe,
                   UnnamedTools unnamed)
    : probe_(probe), unnamed_(unnamed) {
  for (const ToolSetup& tool : tools) {
    tools_[tool.number] = tool.kind == ToolKind::Probe ? nullptr : held(tool);
  }
}

std::shared_ptr<const HeldTool> ToolRack::called(const machine::Tool& tool) const {
  if (tool.number == 0 || tool.number == probe_) {
    return nullptr;
  }
  if (const auto there = tools_.find(tool.number); there != tools_.end()) {
    return there->second;
  }
  if (unnamed_ == UnnamedTools::TouchProbe) {
    return nullptr;
  }
  ToolSetup believed;
  believed.number = tool.number;
  believed.length_mm = tool.length_mm;
  believed.diameter_mm = 2.0 * std::abs(tool.radius_mm);
  if (tool.edge) {
    believed.kind = ToolKind::Turning;
    believed.insert = {tool.edge->lengths_mm, std::abs(tool.radius_mm), tool.edge->position};
  }
  return held(believed);
}

}  // namespace g31::probe

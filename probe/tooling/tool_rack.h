#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "machine/port/machine_events.h"
#include "probe/tooling/tool_setup.h"
#include "probe/tooling/tool_shape.h"

namespace g31::probe {

/// A tool in the spindle, as it truly is.
struct HeldTool {
  ToolSetup setup;
  ToolShape shape;
};

/// What a tool is of which the sheet says nothing.
enum class UnnamedTools {
  Believed,    ///< what the control that calls it believes, a round one
  TouchProbe,  ///< the probe, which stays in the spindle whatever programs call
};

/// What the magazine holds.
class ToolRack {
 public:
  /// @param tools  as they truly are, each number once
  /// @param probe  the number that is the touch probe; nullopt: none is
  ToolRack(const std::vector<ToolSetup>& tools, std::optional<int> probe, UnnamedTools unnamed);

  /// The tool that a program calls.  Null: none, or the touch probe.
  [[nodiscard]] std::shared_ptr<const HeldTool> called(const machine::Tool& tool) const;

 private:
  std::optional<int> probe_;
  UnnamedTools unnamed_;
  std::map<int, std::shared_ptr<const HeldTool>> tools_;
};

}  // namespace g31::probe

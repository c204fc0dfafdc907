#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/port/surroundings.h"
#include "probe/collision/collision_mesh.h"
#include "probe/collision/rigid_touch.h"
#include "probe/sensor/bodies.h"
#include "probe/tooling/tool_rack.h"

namespace g31::probe {

/// The way of a tool's tip in a sweep, as sections are asked about that are told from the tip.
CentreWay way_of_tip(const Point& p_T_tip, const machine::Sweep& sweep);

/// What tools must not meet, with the trees that take long to make.  Immutable, so any number of
/// worlds on any number of threads may share one.
struct ToolObstacles {
  struct Group {
    std::vector<CollisionMesh> meshes;
    std::vector<std::string> names;  ///< of the same
  };
  Group of_cutters;  ///< what is not there to be cut
  Group of_holders;  ///< these and all parts

  /// The plates of tool probes count not: those answer for themselves.
  /// @param mesh  of the same part
  void add(const ProbedPart& part, const CollisionMesh& mesh);
};

/// The tool in the spindle among parts and clamps, where it is no touch probe: it cuts parts and
/// gives no signal; it must not touch clamps, and its holder nothing at all (encounters.def).
///
/// Accuracy: kSectionTouchErrorMm; on a curve the chords that the machine cuts it into.
class CuttingTool final : public machine::Surroundings {
 public:
  CuttingTool(std::shared_ptr<const ToolObstacles> obstacles, std::shared_ptr<const ToolRack> rack);

  /// None: it gives no signal.
  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;
  [[nodiscard]] bool signals_at(const machine::Waypoint& at,
                                const machine::Listening& to) const override;
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int input) const override;
  [[nodiscard]] machine::ToolExtent tool_extent() const override;
  void take(const machine::MachineEvent& event) override;

 private:
  using Sections = std::vector<ProbeSection>;

  [[nodiscard]] std::optional<machine::Obstacle> touch_of(const Sections& sections,
                                                          const ToolObstacles::Group& others,
                                                          const machine::Sweep& sweep) const;

  std::shared_ptr<const ToolObstacles> obstacles_;
  std::shared_ptr<const ToolRack> rack_;
  std::shared_ptr<const HeldTool> held_;  // null: none, or the touch probe
  Sections cutter_;                       // of it, from its lowest point
  Sections holder_;
};

}  // namespace g31::probe

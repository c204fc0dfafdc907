#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "machine/port/surroundings.h"
#include "probe/collision/collision_mesh.h"
#include "probe/sensor/carrier_view.h"
#include "probe/tooling/convex_cast.h"
#include "probe/tooling/spindle.h"
#include "probe/tooling/tool_probe_setup.h"
#include "probe/tooling/tool_rack.h"

namespace g31::probe {

/// What is around a tool probe.
struct ToolProbePlace {
  std::vector<CollisionMesh> chips;  ///< lie on the plate and hand on what touches them
  std::optional<Carrier> carrier;    ///< nullopt: no table turns, or the probe goes with it
};

/// A tool probe: the plate or the beam of light that gives a signal where the tool in the spindle
/// touches it.
///
/// A tool that stands touches with what its teeth are at the angle of the spindle, one that turns
/// when the spindle brings the first tooth (turning_teeth.h).  The signal comes when the plate is
/// pushed by the pre-travel along its normal, shifted along the move by a normal random number of
/// standard deviation `repeatability_mm`.  A beam gives way to nothing and is no obstacle; chuck
/// and shank break it, too.
///
/// Accuracy: kCastErrorMm for what stands.  How deep a tool is in is taken along the normals of the
/// plate's faces.
class ToolProbe final : public machine::Surroundings {
 public:
  /// @param rack   what the spindle may hold
  /// @param index  which of the sheet's tool probes it is: each draws numbers of its own
  ToolProbe(const ToolProbeSetup& setup, std::shared_ptr<const ToolRack> rack, std::uint64_t seed,
            std::uint32_t index, ToolProbePlace place = {});

  /// Rising: where the plate is pushed or the beam broken.  Falling: where it is free again.
  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;
  [[nodiscard]] bool signals_at(const machine::Waypoint& at,
                                const machine::Listening& to) const override;

  /// On a skip move the plate pushed further than it gives way, or chuck and shank touching; on
  /// others anything of the tool that touches.  Leaving a contact is free, pushing deeper is not.
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int input) const override;

  /// Of the tool in the spindle, if the rack knows it.
  [[nodiscard]] machine::ToolExtent tool_extent() const override;
  void take(const machine::MachineEvent& event) override;
  void time_is(double now_s) override { now_s_ = now_s; }

 private:
  using Points = std::span<const machine::Waypoint>;
  using Pieces = std::vector<ConvexShape>;
  /// Where a piece of the tool first touches during a straight piece of the way.
  struct Touch {
    double fraction = 0.0;
    Point n_M = Point::Zero();
    Point p_M = Point::Zero();
  };
  /// A touch on the way into the plate, or into a chip on it.
  struct Push {
    Touch touch;
    double to_signal_mm = 0.0;  ///< of the way
    bool of_plate = true;       ///< the tool was free before; no chip, and no holder in a beam
  };
  /// How the outline of a tool comes to a touch.
  struct Approach {
    double reached_s = 0.0;   ///< since the beginning of the way
    double speed_mm_s = 0.0;  ///< > 0
  };
  /// How deep the tool is in: < 0 where it is not.
  struct Depth {
    double mm = 0.0;
    Point n_M = Point::Zero();
  };

  [[nodiscard]] bool is_wired(int input) const;
  [[nodiscard]] std::optional<machine::Obstacle> obstacle_along(Points way,
                                                                machine::Travel travel) const;
  [[nodiscard]] PlacedShape target() const { return {&plate_, R_MT_, p_M_middle_}; }
  [[nodiscard]] const Pieces& pieces() const;
  [[nodiscard]] PlacedShape placed(const ConvexShape& piece, const machine::Waypoint& at) const;
  [[nodiscard]] std::optional<Touch> first_touch(const Pieces& pieces,
                                                 const machine::Waypoint& from,
                                                 const machine::Waypoint& to) const;
  /// The same for a tool that keeps its turn.
  [[nodiscard]] std::optional<Touch> first_touch_as_turned(const Pieces& pieces,
                                                           const machine::Waypoint& from,
                                                           const Point& way) const;
  [[nodiscard]] std::optional<Push> first_push(const machine::Waypoint& from,
                                               const machine::Waypoint& to) const;
  /// Of a chip on the plate: by the outline of the tool, kSectionTouchErrorMm.
  [[nodiscard]] std::optional<Touch> chip_touch(const machine::Waypoint& from,
                                                const machine::Waypoint& to) const;
  [[nodiscard]] Depth depth_of(const Pieces& pieces, const machine::Waypoint& at) const;
  [[nodiscard]] Depth depth_at(const machine::Waypoint& at) const;
  [[nodiscard]] Depth depth_by_sides(const PlacedShape& tool, double known_mm) const;
  [[nodiscard]] double depth_along(const Depth& side, const PlacedShape& tool) const;
  [[nodiscard]] std::optional<Touch> touch_at(const machine::Waypoint& at) const;
  [[nodiscard]] bool is_on(const machine::Waypoint& at) const;
  [[nodiscard]] bool turns_teeth() const;
  /// How much further than its outline a tool goes that turns with teeth, mm; infinity: no tooth
  /// comes.
  [[nodiscard]] double way_of_turning(const Touch& touch, const machine::Sweep& sweep,
                                      const Approach& approach) const;
  std::optional<machine::SkipTrigger> first_touch_along(Points way, const machine::Listening& to);
  std::optional<machine::SkipTrigger> first_release_along(Points way);
  [[nodiscard]] machine::Contact contact_of(const Touch& touch) const;
  [[nodiscard]] double trigger_shift(std::uint64_t event) const;
  [[nodiscard]] std::optional<machine::Obstacle> collision_on(const Pieces& pieces,
                                                              const machine::Waypoint& from,
                                                              const machine::Waypoint& to) const;
  [[nodiscard]] std::optional<machine::Obstacle> damage_on(const machine::Waypoint& from,
                                                           const machine::Waypoint& to) const;
  [[nodiscard]] std::string tool_name() const;
  /// Whether a piece of the way comes so near that anything of the tool could touch.
  [[nodiscard]] bool comes_near(const machine::Waypoint& from, const machine::Waypoint& to) const;

  ToolProbeSetup setup_;
  std::shared_ptr<const ToolRack> rack_;
  ConvexShape plate_;
  Eigen::Matrix3d R_MT_;
  Point p_M_middle_ = Point::Zero();
  std::vector<Point> normals_M_;  // of the sides that tools push
  bool is_round_ = false;         // further sides all around, across the axis of the plate
  std::vector<CollisionMesh> chips_;
  CarrierView bed_;
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t triggers_asked_ = 0;
  double plate_reach_mm_ = 0.0;  // of its middle
  double now_s_ = 0.0;
  Spindle spindle_;
  std::shared_ptr<const HeldTool> held_;  // null: none, or the touch probe
};

}  // namespace g31::probe

#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "machine/kinematics/axis_chain.h"
#include "machine/port/surroundings.h"

namespace g31::probe {

/// What carries bodies that do not go along with the part.
struct Carrier {
  machine::AxisChain chain;
  /// Of the chain.  nullopt: what the turning tables stand on, taken as what no linear axis moves,
  /// as tool probes beside a table are.
  std::optional<std::size_t> link;
};

/// From the frame of a carrier to that of the part, mm.
/// @param q_M  where the axes stand
Eigen::Isometry3d part_from(const Carrier& carrier, const AxisPositions& q_M);

/// How far what is seen from a carrier may be beside the straight pieces that are told of it, mm.
inline constexpr double kCarrierWayErrorMm = 1e-4;

/// The world is asked in the frame of the part; this tells where the tool is in that of a carrier.
class CarrierView {
 public:
  CarrierView() = default;
  /// @param carrier  nullopt: the part's own, the two frames are one
  explicit CarrierView(std::optional<Carrier> carrier) : carrier_(std::move(carrier)) {}

  /// @param p_T_tip   mm, what the tool turns about, from the gauge point
  /// @param reach_mm  >= 0, of what turns with it
  void take_tool(const Point& p_T_tip, double reach_mm);

  /// Whether no axis turns what is between, so that curves stay what they are.
  [[nodiscard]] bool only_shifts() const;

  [[nodiscard]] machine::Waypoint from_carrier(const machine::Waypoint& at) const;
  /// Pieces on which rotary axes turn are divided until they are straight for the carrier as well,
  /// kCarrierWayErrorMm for everything within reach.
  [[nodiscard]] std::vector<machine::Waypoint> from_carrier(const machine::Way& way) const;
  /// A contact that was found so, back in the frame of the part.
  /// @param way       as the world was asked about it
  /// @param fraction  of it: where the contact is
  [[nodiscard]] machine::Contact for_part(const machine::Contact& contact, const machine::Way& way,
                                          double fraction) const;

 private:
  /// A piece of a way: as it was told, and as it is seen from the carrier.
  struct Piece {
    machine::Waypoint from;
    machine::Waypoint to;
    machine::Waypoint seen_from;
    machine::Waypoint seen_to;
  };

  [[nodiscard]] std::optional<Eigen::Isometry3d> part_from_carrier(
      const machine::Waypoint& at) const;
  [[nodiscard]] bool is_straight(const Piece& piece) const;
  void add(const Piece& piece, int halvings, std::vector<machine::Waypoint>& seen) const;

  std::optional<Carrier> carrier_;
  Point p_T_tip_ = Point::Zero();
  double reach_mm_ = 0.0;
};

/// Obstacles on a carrier, as a set of the world: what another set meets that knows nothing of
/// axes.  It gives no signal of its own.
class CarriedObstacles final : public machine::Surroundings {
 public:
  struct Place {
    Carrier carrier;
    double reach_mm = 0.0;  ///< of the obstacles, from the rotary axes; 0 where there are none
    /// mm, what the machine leads where it is no tip of the inner set.
    std::optional<Point> p_T_led = {};
  };
  /// @param inner  among what stands on that carrier alone; not null
  CarriedObstacles(std::unique_ptr<machine::Surroundings> inner, const Place& place);

  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;
  [[nodiscard]] bool signals_at(const machine::Waypoint& at,
                                const machine::Listening& to) const override;
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int input) const override;
  /// Reaches as far as the obstacles do: where tables turn they come past so fast.
  [[nodiscard]] machine::ToolExtent tool_extent() const override;
  void take(const machine::MachineEvent& event) override;
  void time_is(double now_s) override;

 private:
  [[nodiscard]] std::optional<machine::Obstacle> seen_obstacle(const machine::Way& way,
                                                               machine::Travel travel);

  std::unique_ptr<machine::Surroundings> inner_;
  CarrierView view_;
  double reach_mm_;
  std::optional<Point> p_T_led_;
};

}  // namespace g31::probe

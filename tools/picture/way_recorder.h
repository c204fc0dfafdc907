#pragma once

#include <vector>

#include <Eigen/Core>

#include "interpreter/runtime/output_budget.h"
#include "machine/kinematics/axis_chain.h"
#include "machine/port/forwarding_machine.h"
#include "machine/sim/axis_dynamics.h"
#include "machine/sim/motion_listener.h"
#include "tools/picture/track.h"
#include "tools/picture/way.h"
#include "tools/setup/job.h"

namespace g31::picture {

/// A machine that another one does the work for, and that keeps the ways of a point in the spindle:
/// the stylus ball's centre, or the lowest point of the tool that is there.  M19 turns it about the
/// spindle axis.
///
/// Where rotary axes turn tool and part against each other, all is told in the frame of the part.
/// Straight moves are two points, moves of such axes and chords of 5 degrees at most, rapids of
/// each axis on its own 48 chords; moves of no axis leave no way.
class WayRecorder final : public machine::ForwardingMachine, public machine::MotionListener {
 public:
  /// @param machine  not owned: it must outlive the recorder
  /// @param setup    of that machine
  /// @param p_S_tip  mm, from the spindle gauge point to that point at spindle angle 0 (tip_of)
  /// @param budget   is charged for each chord; outlives the recorder
  WayRecorder(machine::MachinePort& machine, const machine::MachineSetup& setup,
              const Point& p_S_tip, runtime::OutputBudget& budget);

  /// The same for the machine of a set-up: knows which probe no spindle turns, and where the lowest
  /// point of each tool is that programs call.
  /// @param job  outlives the recorder
  WayRecorder(machine::MachinePort& machine, const setup::Job& job, runtime::OutputBudget& budget);

  Result<AxisPositions, machine::MachineFault> move(const machine::LinearMove& move) override;
  Result<AxisPositions, machine::MachineFault> move(const machine::ArcMove& arc) override;
  Result<machine::SkipOutcome, machine::MachineFault> move_until_skip(
      const machine::SkipMove& move) override;
  void change_tool(const machine::ToolChange& change) override;
  void turn_spindle(const machine::SpindleTurn& turn) override;
  machine::MaybeFault take_late_fault() override;
  void set_axis_data(const machine::AxisData& data) override;
  void on_motion(const machine::ExecutedMotion& motion) override;

  /// Of all motion that the machine told of (tell_motions_to).
  [[nodiscard]] const Track& track() const { return track_; }
  /// In the order of the moves.
  [[nodiscard]] const std::vector<Way>& ways() const { return ways_; }
  /// Of skip moves, in order.
  [[nodiscard]] const std::vector<Mark>& contacts() const { return contacts_; }
  [[nodiscard]] const std::vector<Mark>& collisions() const { return collisions_; }
  /// Whether all is told in the frame of the part.
  [[nodiscard]] bool is_of_part() const { return chain_.has_rotary_axes(); }
  /// Where it stands now.
  [[nodiscard]] StylusPlace stylus() const { return stylus_at(machine_.position()); }
  /// Where a picture shows it: at the collision, else at the last touch, else where it stands.
  [[nodiscard]] StylusPlace shown() const;

 private:
  /// Where and when a move begins.
  struct Beginning {
    AxisPositions q_M;
    double time_s;
  };

  [[nodiscard]] Beginning beginning() const { return {machine_.position(), machine_.time_s()}; }
  [[nodiscard]] StylusPlace stylus_at(const AxisPositions& q_M) const;
  /// Of a move that began there and has ended where the machine stands.
  void keep(PathKind kind, const Beginning& from);
  /// The same in chords of equal shares of the path.
  template <typename Path>
  void keep_curve(PathKind kind, const Beginning& from, const Path& path, int chords);
  void keep(Way way, const std::vector<AxisPositions>& q_M);
  /// Where the track has come since, it is charged for: not in the middle of a motion.
  void charge_track();
  void mark(const machine::MachineFault& fault);
  /// Told in the frame of the part, the axes standing there.
  [[nodiscard]] Mark mark_of(const machine::Contact& contact, const AxisPositions& q_M) const;

  machine::AxisDynamics dynamics_;
  Point p_S_tip_;
  Point p_S_probe_ = p_S_tip_;
  const setup::Job* job_ = nullptr;
  int tool_ = 0;  // whose tip it is
  machine::AxisChain chain_;
  Eigen::Matrix3d R_MS_ = Eigen::Matrix3d::Identity();
  std::size_t skips_ = 0;
  std::vector<Way> ways_;
  Track track_;
  std::size_t charged_knots_ = 0;
  std::vector<Mark> contacts_;
  std::vector<Mark> collisions_;
  runtime::OutputBudget& budget_;
};

}  // namespace g31::picture

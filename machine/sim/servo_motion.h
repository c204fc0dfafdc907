#pragma once

#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "machine/port/work_watch.h"
#include "machine/sim/arc_path.h"
#include "machine/sim/command_filter.h"
#include "machine/sim/independent_path.h"
#include "machine/sim/led_path.h"
#include "machine/sim/motion_phases.h"
#include "machine/sim/straight_path.h"
#include "machine/sim/velocity_loop.h"

namespace g31::machine {

/// A way of all axes that the control commands.
using CommandedPath = std::variant<StraightPath, ArcPath, IndependentPath, LedPath>;

/// What a filter behind the interpolation does to the command of a motion.
enum class Smoothing {
  Off,
  On,     ///< what is left of it comes with the next motion
  ToRest  ///< the motion lasts until its command stands
};

/// How the axes follow their commands.
struct ServoLoops {
  AxisPositions time_constants_s = AxisPositions::Zero();  ///< T = 1 / Kv, >= 0
  AxisPositions feed_forward = AxisPositions::Zero();      ///< 0..1
  std::array<VelocityLoopSetup, kAxisCount> velocity = {};
  Smoothing smoothing = Smoothing::Off;
  WorkWatch* watch = nullptr;  ///< of long work on a motion; outlives its motions
};

/// What is left of the moves before.
struct ServoState {
  AxisPositions lag = AxisPositions::Zero();  ///< command minus encoder
  std::array<VelocityLoopState, kAxisCount> velocity = {};
  CommandFilter filter = {};  ///< with what is on its way in it; none: the command stands
};

/// One move as the servo loops carry it out.
///
/// Each axis follows its command like a first-order lag: T q' + q = c + a T c', c the command,
/// T = 1 / Kv, a the feed-forward; at a steady speed it is (1 - a) v / Kv behind.  With T = 0 it is
/// where it is commanded.  An axis with a velocity loop follows as LoopMotion says.  Where a filter
/// smooths the command, c is what comes out of it.
///
/// Accuracy: straight moves and rapids of each axis on its own are solved in closed form; on arcs
/// the command is taken within kArcCommandErrorMm, on led ways within kLedErrorMm; for
/// velocity loops see LoopMotion.
class ServoMotion {
 public:
  /// @param phases    the speed along the path; it may stop before the end of the path
  /// @param state     when the move begins
  ServoMotion(const CommandedPath& path, const MotionPhases& phases, const ServoState& state,
              const ServoLoops& loops);

  /// To be called in each step of long work on the motion.
  void look() const {
    if (watch_ != nullptr) {
      watch_->look();
    }
  }

  /// What drives the axes: the motion along their common path, or that of each axis which goes on
  /// its own, in its own units.
  [[nodiscard]] std::span<const MotionPhases> drives() const { return drives_; }

  /// Until the command has come to rest, or until the next motion takes on what the filter holds.
  [[nodiscard]] double duration_s() const { return duration_s_; }

  /// Where the command comes to rest.
  [[nodiscard]] const AxisPositions& end() const { return q_M_end_; }

  /// @param time_s  >= 0 from the beginning of the move; from duration_s() on: as then
  [[nodiscard]] AxisPositions commanded_at(double time_s) const;

  /// @param time_s  >= 0; after duration_s() the lag dies away
  [[nodiscard]] AxisPositions encoder_at(double time_s) const;

  /// Command minus encoder.
  [[nodiscard]] AxisPositions lag_at(double time_s) const {
    return commanded_at(time_s) - encoder_at(time_s);
  }

  /// What is left of the move at a time.
  [[nodiscard]] ServoState state_at(double time_s) const;

  /// When, from duration_s() on, no axis lags by more than its width.  @param widths  > 0
  [[nodiscard]] double in_position_s(const AxisPositions& widths) const;

  /// Times from 0 to a time, so close that between two of them no axis turns back far.
  [[nodiscard]] std::vector<double> steps_until(double time_s) const;

 private:
  using Cubic = std::array<AxisPositions, 4>;  // by powers of the time in the piece
  struct Piece {
    double begin_s = 0.0;
    double duration_s = 0.0;
    Cubic command;
    Cubic response;          // of the encoder, apart from what dies away
    AxisPositions dying;     // at the beginning
    bool turns_back = true;  // there an axis may; false: all go on as in the piece before
  };

  /// How many powers of the time the command of a piece has, 1 to 3: see kLeastPartOfCubic.
  [[nodiscard]] int powers_of(double duration_s) const;
  void add_phase(const StraightPath& path, const MotionPhase& phase);
  void add_phase(const ArcPath& path, const MotionPhase& phase);
  void add_phase(const IndependentPath& path, const MotionPhase& phase);
  void add_phase(const LedPath& path, const MotionPhase& phase);
  void add_piece(const Cubic& command, double duration_s);
  void rest_filter();
  void follow_piece(const Cubic& command, double duration_s);
  [[nodiscard]] const Piece& piece_at(double time_s) const;
  [[nodiscard]] AxisPositions decay(double time_s) const;
  [[nodiscard]] AxisPositions encoder_in(const Piece& piece, double time_s) const;
  void start_velocity_loops(const ServoLoops& loops, const ServoState& state);
  void follow_in_velocity_loops(const Cubic& command, double duration_s);
  /// Axes with a velocity loop are where it has brought them.
  void take_velocity_loops(AxisPositions& q_M, double time_s) const;

  std::vector<MotionPhases> drives_;
  AxisPositions time_constants_s_;
  AxisPositions feed_forward_s_;  // times T
  AxisPositions q_M_end_;
  AxisPositions q_M_commanded_;  // at the end of what is already built
  Smoothing smoothing_;
  CommandFilter filter_;
  AxisPositions lag_;  // at the end of what is already built
  double duration_s_ = 0.0;
  double transient_s_ = 0.0;  // how long what was left of the move before matters
  double transient_step_s_ = 0.0;
  std::vector<Piece> pieces_;
  std::array<std::optional<LoopMotion>, kAxisCount> velocity_loops_;
  bool has_velocity_loops_ = false;
  WorkWatch* watch_;
};

/// How far a command on an arc may be beside the arc, mm.
inline constexpr double kArcCommandErrorMm = 1e-10;

}  // namespace g31::machine

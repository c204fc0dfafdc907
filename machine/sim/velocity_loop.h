#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "machine/port/work_watch.h"

namespace g31::machine {

/// The velocity loop of an axis, with integral action, and the friction it works against; all per
/// unit of the axis' mass, mm or deg and seconds.
struct VelocityLoopSetup {
  double gain_per_s = 0.0;       ///< proportional; 0: the axis takes the commanded speed at once
  double reset_s = 0.01;         ///< > 0, of the integral part
  double friction_per_s2 = 0.0;  ///< >= 0: what the drive needs to keep the axis moving
  double friction_way = 0.02;    ///< > 0: over which friction turns round after a reversal

  [[nodiscard]] bool is_there() const { return gain_per_s > 0.0; }
};

/// What an axis behind a velocity loop keeps from move to move, apart from its position.
struct VelocityLoopState {
  double speed = 0.0;
  double integral = 0.0;  ///< of the speed that is missing
  double friction = 0.0;  ///< per unit of mass, against the motion
};

/// Axis position, speed and the rest at one time.
struct LoopSample {
  double time_s = 0.0;
  double position = 0.0;
  VelocityLoopState state;
};

/// A cubic by powers of the time, a command.
using CommandCubic = std::array<double, 4>;

/// One axis with position and velocity loop as it follows its command:
///
///   e = Kp (c - q) + a c' - q',   q'' = w (e + 1/Ti integral e) - f
///   f' = (F sign q' - f) |q'| / d
///
/// c is the command, a the feed-forward.  Friction after P. Dahl (1968): it turns round over some d
/// after a reversal, in which the integral part has not followed yet, so the axis stays behind
/// (stick motion; Kakino, Matsubara, Lin, Owaki 1999).
///
/// Of a command that lasts long only every so many steps are kept: what is between is computed
/// again where somebody asks for it, with the same result, bit for bit.
///
/// Accuracy: midpoint rule in steps of kLoopStepS at most; tests/machine/velocity_loop_test.cc
/// holds 1e-3 um on the circle of its own.
class LoopMotion {
 public:
  struct Setup {
    VelocityLoopSetup loop;
    double position_gain_per_s = 0.0;  ///< Kp > 0
    double feed_forward = 0.0;
    WorkWatch* watch = nullptr;  ///< looked at in each step
  };
  /// @param position  where the axis is at the time 0
  LoopMotion(const Setup& setup, double position, const VelocityLoopState& state);

  /// The command goes on for a time; its cubic counts from its own beginning.
  void follow(const CommandCubic& command, double duration_s);
  /// From now on the command rests.
  void rest_at(double command) { rest_ = command; }

  /// @param time_s  >= 0; behind the end of the command the axis comes to rest at it
  [[nodiscard]] LoopSample at(double time_s) const;

  /// When, from the end of the command on, the axis is first within a width of it.
  [[nodiscard]] double within_s(double width) const;

 private:
  /// Steps of a long command whose ends alone are among the samples.
  struct Stretch {
    LoopSample start;
    double end_s = 0.0;
    CommandCubic command = {};
    std::int64_t first = 0;  ///< step of the command
    std::int64_t steps = 0;
    double h = 0.0;
  };

  [[nodiscard]] LoopSample stepped(const LoopSample& now, const CommandCubic& command, double t,
                                   double h) const;
  void step(const CommandCubic& command, double t, double h) const;
  void step_in_stretches(const CommandCubic& command, std::int64_t steps, double h);
  void rest_until(double time_s) const;
  /// The samples of the stretch that begins at a time; the usual ones where none does.
  [[nodiscard]] const std::vector<LoopSample>& samples_from(double begin_s) const;

  Setup setup_;
  double rest_ = 0.0;
  double command_end_s_ = 0.0;
  mutable std::vector<LoopSample> samples_;  ///< grows as far as somebody asks
  mutable bool is_at_rest_ = false;
  std::vector<Stretch> stretches_;              // rising
  mutable std::vector<LoopSample> in_stretch_;  // the one that was asked for last
};

inline constexpr double kLoopStepS = 1e-4;

/// Whether an axis with these loops comes to rest instead of swinging ever farther.
bool settles(const LoopMotion::Setup& setup);

}  // namespace g31::machine

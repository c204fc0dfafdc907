#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "machine/port/surroundings.h"
#include "machine/sim/machine_setup.h"
#include "machine/sim/servo_motion.h"
#include "machine/sim/true_position.h"

namespace g31::machine {

/// Something that happens to a motion, and when.
template <typename Event>
struct Timed {
  Event event;
  double time_s = 0.0;  ///< since the beginning of the motion
};

/// How a motion is carried out.
struct Carriage {
  Travel travel = Travel::Feed;
  BlockEnd ends = BlockEnd::ExactStop;
  ContourControl contour_control = ContourControl::Off;
};

/// mm or deg: nearer its place an axis stands.
inline constexpr double kRestsWithin = 1e-6;

/// The axes of a machine as they are: behind their commands, beside their encoders, on tables that
/// turn.  Keeps their state from motion to motion.
class RealAxes {
 public:
  explicit RealAxes(const MachineSetup& setup);

  /// Whether all of them are where they are commanded, bit for bit, and the part never turns.
  [[nodiscard]] bool are_ideal() const { return is_ideal_; }

  /// Whether their ways do not depend on the speed: they neither lag nor stick.
  [[nodiscard]] bool follow_at_once() const { return follows_at_once_; }

  /// Whether any of them is behind its command, or a filter is.
  [[nodiscard]] bool lag() const { return lags_ || filter_.is_there(); }

  /// The motion along a path that begins now.
  [[nodiscard]] ServoMotion motion(const CommandedPath& path, const MotionPhases& phases,
                                   ContourControl contour_control = ContourControl::Off) const;
  /// The same of a feed whose command the filter smooths.
  /// @param comes_to_rest  at its end the command stands; else what is left of it comes with the
  /// next
  [[nodiscard]] ServoMotion smoothed_motion(const CommandedPath& path, const MotionPhases& phases,
                                            bool comes_to_rest) const;
  /// Whether a filter smooths feeds.
  [[nodiscard]] bool has_filter() const { return filter_.is_there(); }
  /// Whether the command of the last motion has not come to rest yet.
  [[nodiscard]] bool is_smoothing() const { return state_.filter.is_there(); }
  /// For how long, s.
  [[nodiscard]] double smoothes_s() const { return state_.filter.rest_s(); }

  /// When the control takes a motion as done: at the end of the command, or once the axes have
  /// followed within a window.
  [[nodiscard]] double done_s(const ServoMotion& motion, BlockEnd end) const;

  /// What the world says to a motion; contacts in the machine's frame.
  [[nodiscard]] std::optional<Timed<SkipTrigger>> first_signal(const ServoMotion& motion,
                                                               const Listening& to,
                                                               Surroundings& world) const;
  [[nodiscard]] std::optional<Timed<Obstacle>> first_obstacle(const ServoMotion& motion,
                                                              const Carriage& how,
                                                              Surroundings& world) const {
    return first_obstacle(motion, how.travel, done_s(motion, how.ends), world);
  }
  [[nodiscard]] std::optional<Timed<Obstacle>> first_obstacle(const ServoMotion& motion,
                                                              Travel travel, double until_s,
                                                              Surroundings& world) const;

  /// When, from the end of its command on, nothing of a motion is left that could be seen.
  [[nodiscard]] static double rests_s(const ServoMotion& motion) {
    return motion.in_position_s(AxisPositions::Constant(kRestsWithin));
  }

  /// Carries out a motion until some time.
  void follow(const ServoMotion& motion, double until_s);

  /// Comes to rest at a position at once.
  void stop_at(const AxisPositions& q_M);

  /// How what is wired to an input is asked while the axes stand.
  [[nodiscard]] Listening listening_at(const AxisPositions& q_M, int input) const;
  /// Where the tool tip truly is for the part when the axes have come to q_M.
  [[nodiscard]] Waypoint tip(const AxisPositions& q_M) const;
  /// The same for another point of the tool's side.  @param p_T  mm, from the gauge point
  [[nodiscard]] Waypoint place_of(const Point& p_T, const AxisPositions& q_M) const;
  /// Positions of the encoders at a fraction 0..1 of a way.
  using Encoders = std::function<AxisPositions(double)>;
  /// The way that a skip move has taken: in one piece unless a rotary axis moved, then in pieces of
  /// kSkipTurnDeg.
  /// @param tip_from  what tip() of its beginning was before the move
  [[nodiscard]] std::vector<Waypoint> way_taken(const Waypoint& tip_from,
                                                const Encoders& went) const;
  /// What was met in the frame of the part, in that of the machine.
  [[nodiscard]] Contact in_machine(const AxisPositions& q_M, const Contact& of_part) const;

  /// Is looked at in long work on all motions from now on; outlives this.
  void watch(WorkWatch& watch) { loops_.watch = loops_ahead_.watch = &watch; }
  /// To be called in each step of other long work on a motion.
  void look() const {
    if (loops_.watch != nullptr) {
      loops_.watch->look();
    }
  }

  /// How near its place an axis has arrived, and what smooths feeds.
  void take(const AxisData& data);

  /// The control adds these to the places of the axes from now on.  @param q_M  where they stand
  void correct_by(AxisCorrections corrections, const AxisPositions& q_M);

  /// Another tool is in the spindle.  @param p_T_tip  mm, its tip from the gauge point
  void take_tool(const Point& p_T_tip);

  [[nodiscard]] const TruePosition& truth() const { return truth_; }

 private:
  void look_whether_ideal();

  TruePosition truth_;
  ServoLoops loops_;
  ServoLoops loops_ahead_;  // with feed-forward
  AxisPositions stop_fine_;
  AxisPositions stop_coarse_;
  ServoState state_;
  CommandFilter filter_;  // at rest
  bool lags_;
  bool is_ideal_;
  bool follows_at_once_;
};

/// 0.5 m away from its axis, so small a turn leaves the straight line by 5e-5 mm.
inline constexpr double kSkipTurnDeg = 0.05;

}  // namespace g31::machine

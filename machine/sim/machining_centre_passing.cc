// Moves that pass on into each other.

#include <algorithm>
#include <type_traits>
#include <utility>

#include "machine/sim/arc_path.h"
#include "machine/sim/machining_centre.h"
#include "machine/sim/motion_profile.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {

void MachiningCentre::end_passing() {
  keeps_feed_ = false;
  if (!continuous_.is_empty()) {
    pass(continuous_.finish());
  }
}

void MachiningCentre::stand_still() {
  end_passing();
  if (!late_ && real_.is_smoothing()) {
    find_late(carry_out_really(real_.smoothed_motion(StraightPath(q_M_, q_M_), {}, true),
                               {Travel::Feed, BlockEnd::CommandStop}));
  }
}

void MachiningCentre::find_late(MaybeFault fault) {
  late_ = std::move(fault);
  if (late_) {
    late_->tag = followed_;
  }
}

void MachiningCentre::come_to_rest() {
  stand_still();
  if (late_ || surroundings_ == nullptr || real_.follow_at_once()) {
    return;
  }
  const ServoMotion motion = real_.motion(StraightPath(q_M_, q_M_), {});
  const double moves_s = RealAxes::rests_s(motion);
  if (moves_s > 0.0) {
    if (auto obstacle = real_.first_obstacle(motion, Travel::Feed, moves_s, *surroundings_)) {
      find_late(break_off(motion, *std::move(obstacle)));
    }
  }
}

MaybeFault MachiningCentre::take_late_fault() {
  return std::exchange(late_, std::nullopt);
}

double MachiningCentre::time_s() const {
  if (continuous_.is_empty()) {
    return clock_.now_s() + (real_.is_smoothing() ? real_.smoothes_s() : 0.0);
  }
  Clock at_rest = clock_;
  at_rest.advance(continuous_.duration_s());
  return at_rest.now_s();
}

template <typename Path>
MaybeFault MachiningCentre::feed(const Path& path, const PathLimits& limits,
                                 const Passing& passing) {
  if (joins(passing)) {
    return pass_on(path, limits, passing);
  }
  if (passing.ends == BlockEnd::PassOn || keeps_feed_ ||
      (real_.has_filter() && passing.contour_control == ContourControl::Off)) {
    MotionPhases phases(MotionState{0.0, limits.speed, 0.0});
    phases.append(path.length() / limits.speed, 0.0);
    return keep_feed(path, phases, passing.ends);
  }
  const MotionProfile profile(path.length(), limits.speed, limits.acceleration, limits.jerk);
  return carry_out(path, profile, {Travel::Feed, passing.ends, passing.contour_control});
}
template MaybeFault MachiningCentre::feed(const StraightPath&, const PathLimits&, const Passing&);
template MaybeFault MachiningCentre::feed(const ArcPath&, const PathLimits&, const Passing&);
template MaybeFault MachiningCentre::feed(const LedPath&, const PathLimits&, const Passing&);

bool MachiningCentre::joins(const Passing& passing) const {
  const bool plans = !real_.lag() || passing.contour_control != ContourControl::Off;
  return plans && (passing.ends == BlockEnd::PassOn || !continuous_.is_empty());
}

/// Acceleration after interpolation: the command steps to the feed and from it, the axes smooth it.
MaybeFault MachiningCentre::keep_feed(const CommandedPath& path, const MotionPhases& phases,
                                      BlockEnd ends) {
  end_passing();
  if (late_) {
    return take_late_fault();
  }
  keeps_feed_ = ends == BlockEnd::PassOn;
  return carry_out_really(real_.smoothed_motion(path, phases, !keeps_feed_), {Travel::Feed, ends});
}

[[gnu::hot]] double MachiningCentre::speed_at_corner(const ContinuousPath::Move& behind,
                                                     const AxisPositions& along_start) const {
  const ContinuousPath::Move& before = continuous_.last();
  const double speed = dynamics_.corner_speed(before.along_end, along_start);
  const double tolerance = std::min(before.corner_tolerance, behind.corner_tolerance);
  if (tolerance <= 0.0) {
    return speed;
  }
  return std::max(speed,
                  dynamics_.curve_speed(before.along_end, along_start,
                                        {tolerance, 0.5 * std::min(before.length, behind.length)}));
}

template <typename Path>
MaybeFault MachiningCentre::pass_on(const Path& path, const PathLimits& limits,
                                    const Passing& passing) {
  const double length = path.length();
  ContinuousPath::Move move{length, limits, 0.0, path.slope_at(1.0) / length,
                            passing.corner_tolerance};
  if (!continuous_.is_empty()) {
    constexpr bool kIsStraight = std::is_same_v<Path, StraightPath>;
    move.corner_speed = speed_at_corner(
        move, kIsStraight ? move.along_end : AxisPositions(path.slope_at(0.0) / length));
  }
  continuous_.add(move);
  if (continuous_.keeps_ways()) {
    continuous_.keep(path, passing);
  }
  if (surroundings_ != nullptr && real_.follow_at_once()) {
    if (auto obstacle = obstacle_in_passing(path, limits)) {
      const AxisPositions q_M_stop = path.at(obstacle->fraction);
      pass(continuous_.finish_at(obstacle->fraction * path.length()));
      real_.stop_at(q_M_stop);
      return stop_at(*std::move(obstacle), q_M_stop, 0.0);
    }
  }
  if (passing.ends == BlockEnd::PassOn) {
    pass(continuous_.release());
  } else {
    stand_still();
    settle(path.to(), passing.ends);
  }
  return take_late_fault();
}

/// The way of axes that follow at once is the same at every speed.  The fraction is of the path.
template <typename Path>
std::optional<Obstacle> MachiningCentre::obstacle_in_passing(const Path& path,
                                                             const PathLimits& limits) {
  if constexpr (!std::is_same_v<Path, LedPath>) {
    if (real_.are_ideal()) {
      return obstacle_on(path, Travel::Feed);
    }
  }
  const MotionProfile alone(path.length(), limits.speed, limits.acceleration, limits.jerk);
  auto obstacle = real_.first_obstacle(real_.motion(path, alone.phases()),
                                       {Travel::Feed, BlockEnd::PassOn}, *surroundings_);
  if (!obstacle) {
    return std::nullopt;
  }
  obstacle->event.fraction = std::min(1.0, alone.distance_at(obstacle->time_s) / path.length());
  return std::move(obstacle->event);
}

[[gnu::hot]] void MachiningCentre::pass(const ContinuousPath::Passed& passed) {
  if (!real_.follow_at_once()) {
    for (const Travelled& way : passed.ways) {
      travel_late(way);
    }
    return;
  }
  double start_s = clock_.now_s();
  // Ways are also known where axes have not always followed at once: then nobody may want them.
  for (const Travelled& way : passed.ways) {
    if (is_watched()) {
      show({start_s, way.duration_s, real_.motion(way.path, way.phases), real_.truth()});
    }
    start_s += way.duration_s;
  }
  if (passed.seconds > 0.0) {
    clock_.advance(passed.seconds);
  }
}

void MachiningCentre::travel_late(const Travelled& way) {
  if (late_ || way.phases.duration_s() == 0.0) {
    return;
  }
  const ContourControl control = way.passing.contour_control;
  late_ = carry_out_really(real_.motion(way.path, way.phases, control),
                           {Travel::Feed, BlockEnd::PassOn, control});
  if (late_) {
    late_->tag = way.passing.tag;
    continuous_.drop();
  }
}

/// An exact stop at the end of moves that passed on: the axes follow to their place.
void MachiningCentre::settle(const AxisPositions& q_M_end, BlockEnd ends) {
  if (late_ || real_.follow_at_once()) {
    return;
  }
  const ServoMotion motion = real_.motion(StraightPath(q_M_end, q_M_end), {});
  if (real_.done_s(motion, ends) > 0.0) {
    late_ = carry_out_really(motion, {Travel::Feed, ends});
  }
}

}  // namespace g31::machine

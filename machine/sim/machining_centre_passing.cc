// Moves that pass on into each other.

#include <algorithm>
#include <utility>

#include "machine/sim/arc_path.h"
#include "machine/sim/machining_centre.h"
#include "machine/sim/motion_profile.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {

void MachiningCentre::stand_still() {
  if (!continuous_.is_empty()) {
    pass(continuous_.finish());
  }
}

double MachiningCentre::time_s() const {
  if (continuous_.is_empty()) {
    return clock_.now_s();
  }
  Clock at_rest = clock_;
  at_rest.advance(continuous_.duration_s());
  return at_rest.now_s();
}

bool MachiningCentre::joins(BlockEnd ends) const {
  return real_.follow_at_once() && (ends == BlockEnd::PassOn || !continuous_.is_empty());
}

template <typename Path>
std::optional<MachineFault> MachiningCentre::pass_on(const Path& path, const PathLimits& limits,
                                                     BlockEnd ends) {
  const double length = path.length();
  double corner_speed = 0.0;
  if (!continuous_.is_empty()) {
    corner_speed = dynamics_.corner_speed(continuous_.along_end(), path.slope_at(0.0) / length);
  }
  continuous_.add({length, limits, corner_speed, path.slope_at(1.0) / length});
  if (continuous_.keeps_ways()) {
    continuous_.keep(path);
  }
  if (surroundings_ != nullptr) {
    if (auto obstacle = obstacle_in_passing(path, limits)) {
      const AxisPositions q_M_stop = path.at(obstacle->fraction);
      pass(continuous_.finish_at(obstacle->fraction * path.length()));
      real_.stop_at(q_M_stop);
      return stop_at(*std::move(obstacle), q_M_stop, 0.0);
    }
  }
  if (ends == BlockEnd::ExactStop) {
    stand_still();
  } else {
    pass(continuous_.release());
  }
  return std::nullopt;
}

/// The way of axes that follow at once is the same at every speed.  The fraction is of the path.
template <typename Path>
std::optional<Obstacle> MachiningCentre::obstacle_in_passing(const Path& path,
                                                             const PathLimits& limits) {
  if (real_.are_ideal()) {
    return obstacle_on(path, Travel::Feed);
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

void MachiningCentre::pass(const ContinuousPath::Passed& passed) {
  double start_s = clock_.now_s();
  for (const Travelled& way : passed.ways) {
    sampler_->show({start_s, way.duration_s, real_.motion(way.path, way.phases), real_.truth()},
                   resolution_);
    start_s += way.duration_s;
  }
  if (passed.seconds > 0.0) {
    clock_.advance(passed.seconds);
  }
}

template std::optional<MachineFault> MachiningCentre::pass_on(const StraightPath&,
                                                              const PathLimits&, BlockEnd);
template std::optional<MachineFault> MachiningCentre::pass_on(const ArcPath&, const PathLimits&,
                                                              BlockEnd);

}  // namespace g31::machine

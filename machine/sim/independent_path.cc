#include "machine/sim/independent_path.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"
#include "machine/sim/arc_path.h"

namespace g31::machine {

IndependentPath::IndependentPath(const AxisPositions& q_M_from, const AxisPositions& q_M_to,
                                 const Profiles& profiles)
    : q_M_from_(q_M_from), q_M_to_(q_M_to), profiles_(profiles) {
  for (const auto& profile : profiles_) {
    duration_s_ = std::max(duration_s_, profile ? profile->duration_s() : 0.0);
  }
}

AxisPositions IndependentPath::at(double fraction) const {
  G31_EXPECTS(fraction >= 0.0);
  if (fraction >= 1.0) {
    return q_M_to_;
  }
  const double time_s = fraction * duration_s_;
  AxisPositions q_M = q_M_to_;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (profiles_[i] && time_s < profiles_[i]->duration_s()) {
      q_M[axis] = q_M_from_[axis] +
                  std::copysign(profiles_[i]->distance_at(time_s), q_M_to_[axis] - q_M_from_[axis]);
    }
  }
  return q_M;
}

double IndependentPath::bend() const {
  double squares = 0.0;
  for (std::size_t i = 0; i < kLinearAxisCount; ++i) {
    const double acceleration = profiles_[i] ? profiles_[i]->acceleration() : 0.0;
    squares += acceleration * acceleration;
  }
  return duration_s_ * duration_s_ * std::sqrt(squares);
}

int IndependentPath::chord_count() const {
  const double chords = std::sqrt(bend() / (8.0 * kChordErrorMm));
  return static_cast<int>(std::clamp(std::ceil(chords), 1.0, double{kMostChords}));
}

MotionPhases PassingTime::phases() const {
  MotionPhases phases(MotionState{0.0, 1.0, 0.0});
  phases.append(duration_s_, 0.0);
  return phases;
}

}  // namespace g31::machine

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// Speed over time.
struct SpeedRecord {
  std::vector<double> t;      ///< s, in the middle of each interval
  std::vector<double> speed;  ///< mm/s
  std::size_t interval = 1;   ///< samples over which it is taken
};

/// A fall of speed.
struct SpeedDip {
  double time = 0.0;   ///< s, where the speed is lowest
  double speed = 0.0;  ///< mm/s, the lowest
  double width = 0.0;  ///< s, below 90 percent of the usual speed
};

struct SpeedEvaluation {
  double usual = 0.0;  ///< mm/s, median while the path is under way
  double most = 0.0;   ///< mm/s
  double least = 0.0;  ///< mm/s, between the first and the last time at 90 percent of the usual
  std::vector<SpeedDip> dips;
};

/// |P_t - P_(t-1)| / dt (Yatsuzaki, equation 28), over so many samples as keep the scatter from one
/// value to the next below one percent; 64 at most.  At least two samples.
SpeedRecord speed_of(const PlaneSamples& samples);

/// Nothing where the path does not move.  A dip begins below 90 percent of the usual speed and ends
/// when 95 percent are reached again.
std::optional<SpeedEvaluation> evaluate_speed(const SpeedRecord& record);

}  // namespace g31::metrology

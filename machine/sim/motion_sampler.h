#pragma once

#include <cstdint>
#include <optional>

#include "machine/port/trace.h"
#include "machine/sim/motion_listener.h"

namespace g31::machine {

/// Takes samples at whole multiples of a period, the first at 0, and one where motion ends.
class MotionSampler {
 public:
  /// @param period_s  > 0
  MotionSampler(double period_s, TraceSink& sink);

  /// Motions follow each other in time without gaps.
  void show(const ExecutedMotion& motion, const AxisPositions& resolution);
  /// No motion follows.
  void end();

 private:
  double period_s_;
  TraceSink& sink_;
  std::uint64_t next_ = 0;
  std::optional<TraceSample> last_;  ///< of the end of the last motion, if it is between two others
};

/// A position as encoders with steps report it; a resolution of 0 has no steps.
AxisPositions in_steps(const AxisPositions& q_M, const AxisPositions& resolution);

}  // namespace g31::machine

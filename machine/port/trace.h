#pragma once

#include "machine/units/axis_positions.h"

namespace g31::machine {

/// Where the axes are at one time; mm and deg, machine coordinates.
struct TraceSample {
  double time_s = 0.0;          ///< since the start of the program
  AxisPositions q_M_commanded;  ///< what the control asks of the position loops
  AxisPositions q_M_encoder;    ///< what the scales read, in whole steps where they have steps
  AxisPositions q_M_true;       ///< where the tool tip truly is
};

/// Takes the samples of a run, in the order of time.
class TraceSink {
 public:
  TraceSink() = default;
  TraceSink(const TraceSink&) = delete;
  TraceSink& operator=(const TraceSink&) = delete;
  virtual ~TraceSink() = default;

  virtual void on_sample(const TraceSample& sample) = 0;
  /// One more, of where all motion has ended: of a run that is over, so nothing may be thrown.
  virtual void on_end(const TraceSample& sample) { on_sample(sample); }
};

}  // namespace g31::machine

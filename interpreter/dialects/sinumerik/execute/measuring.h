#pragma once

#include "interpreter/dialects/sinumerik/code/word_limits.h"
#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "machine/port/skip_signal.h"

namespace g31::sinumerik {

/// What the words of a block make of the probe.
struct Measuring {
  int probe = 1;
  machine::SignalEdge edge = machine::SignalEdge::Rising;
  machine::AfterSignal after = machine::AfterSignal::Stop;
  bool by_action = false;  ///< DELDTG: nothing is latched
  int further = 0;         ///< a second probe, 0: none
  MeasuringMode mode = MeasuringMode::AnyOrder;
};

/// Of a block that listens to the probe.
Result<Measuring, Failure> measuring_of(const Channel& channel, const BlockWords& words);

// Source: NC programming, axial measuring: MEASA and MEAWA are of path and of positioning axes;
// MEAS and MEAW are of all axes of the block.

/// Whether it is a positioning axis that measures, and not the path.
bool measures_positioning(const Block& block);
/// On the control the axes of a block move at once, here one by one: with others the touch would be
/// another one.
MaybeFailure cannot_measure_positioning(const Block& block);

}  // namespace g31::sinumerik

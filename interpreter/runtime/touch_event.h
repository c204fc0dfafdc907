#pragma once

#include "interpreter/runtime/observer.h"
#include "machine/port/machine_port.h"

namespace g31::runtime {

/// What a skip move came to, as the observer hears it; block and place are still to be said.  A
/// signal that was there already counts as one.
/// @param q_M_from  where the move began
/// @param q_M_now  where the axes stand: what was latched when nothing was
TouchEvent touch_event(const machine::LinearMove& way, const machine::SkipOutcome& outcome,
                       const AxisPositions& q_M_from, const AxisPositions& q_M_now);

}  // namespace g31::runtime

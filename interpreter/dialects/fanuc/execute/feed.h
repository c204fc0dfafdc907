#pragma once

#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/state/failure.h"

namespace g31::fanuc {

/// The feed in mm/min in force, or why there is none; G95 takes the spindle speed S along (MB-314).
Result<double, Failure> feed_in_force(const Control& control);

/// A programmed feed as dry run and feed override change it, mm/min (MB-128, MB-268).
double switched_feed(const Control& control, double feed_mm_min);

}  // namespace g31::fanuc

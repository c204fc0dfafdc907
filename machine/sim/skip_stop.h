#pragma once

#include "machine/port/machine_port.h"
#include "machine/sim/machine_setup.h"
#include "machine/sim/motion_profile.h"

namespace g31::machine {

/// How a skip move ends after the contact; distances in path units, counted from the contact.
struct SkipStop {
  double latched_after = 0.0;  ///< travelled when the control stores the position
  double stopped_after = 0.0;  ///< travelled when the axes are at rest; >= latched_after
  double duration_s = 0.0;     ///< from the start of the move until then
};

/// How long a control takes.
struct SkipDelays {
  double latch_s = 0.0;  ///< >= 0, from the contact to the latch
  double stop_s = 0.0;   ///< >= 0, from the latch until the axes begin to brake
};

/// What follows a contact on the way: for the delays the axes go on along the commanded profile;
/// after the first the control latches, after the second they stop.
///
/// The commanded motion goes no further than its end: a delay that outlasts the move latches
/// there, and the clock still runs until the latch.
/// @param contact_distance  path units from the start, 0..profile.length()
SkipStop stop_after_contact(const MotionProfile& profile, double contact_distance,
                            const SkipDelays& delays, Stopping stopping);

/// Worst error of latched_after and stopped_after, relative to the length of the path, over 20 000
/// stops against long double, times five; tests/machine/skip_stop_test.cc holds it.
inline constexpr double kSkipStopError = 2.2e-15;

/// What a skip move listens to at one input; when it is where, its axes know.
Listening listening_of(const SkipMove& move, int input, const MotionProfile& profile);

}  // namespace g31::machine

#pragma once

#include <map>
#include <string>
#include <utility>

#include "machine/kinematics/axis_chain.h"
#include "tests/support/measuring_run.h"

// Runs programs on the five-axis machines of tests/support/worked_machines.h.

namespace g31::testing {

/// The set-up sheet of a chain: rotary axes with their lines, a probe of 120 mm to the end of its
/// ball as tool 1, calibrated; G54 at a place.
/// @param travel  deg, of rotary axes by letter; -36000 to 36000 where nothing is said
std::string five_axis_sheet(const machine::AxisChainSetup& chain, const Point& work_offset,
                            const std::map<char, std::pair<double, double>>& travel = {});

/// What the control believes, where it is another chain.
std::string believed_sheet(const machine::AxisChainSetup& chain);

}  // namespace g31::testing

#pragma once

#include <string>

#include "machine/kinematics/axis_chain.h"

namespace g31::testing {

/// NC text: the elements $NK_ of a machine, the transformation 1 named CHAIN on them and tool
/// carrier 2 named CARRIED.  Elements CORR1 and CORR2 take the corrections of rotary axes 1 and 2.
std::string chain_text(const machine::AxisChainSetup& chain);

}  // namespace g31::testing

#pragma once

#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "machine/kinematics/axis_chain.h"

namespace g31::fanuc {

/// Parameters 19680 to 19714 as the machine of the set-up sheet would have them, where nothing has
/// set them.  A direction that lies in none of the planes XY, YZ and ZX stays 0.
void fill_kinematics(Parameters& parameters, const machine::AxisChainSetup& sheet);

/// What the parameters make the control take the machine for: the sheet's chain, where they say no
/// more than that.  Parameters that make no machine give one without rotary axes.
machine::AxisChainSetup believed_chain(const Parameters& parameters,
                                       const machine::AxisChainSetup& sheet);

}  // namespace g31::fanuc

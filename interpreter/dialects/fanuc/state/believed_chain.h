#pragma once

#include <Eigen/Geometry>

#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "machine/kinematics/axis_chain.h"

namespace g31::fanuc {

/// Parameters 19680 to 19714 as the machine of the set-up sheet would have them, where nothing has
/// set them.  A direction that lies in none of the planes XY, YZ and ZX stays 0.
void fill_kinematics(Parameters& parameters, const machine::AxisChainSetup& sheet);

/// What a control takes a machine for.
struct BelievedMachine {
  machine::AxisChainSetup chain;
  /// How the tool is held with all rotary axes at 0, from one that hangs upright at the gauge
  /// point: by parameters 19697 to 19699, and by a hypothetical axis of the head.
  Eigen::Isometry3d tool_at_rest = Eigen::Isometry3d::Identity();
};

/// What the parameters make the control take the machine for: the sheet's chain, where they say no
/// more than that.  Parameters that make no machine give one without rotary axes.
///
/// A hypothetical axis (19696.0 and .1) stands at an angle for good: one of the head tilts the
/// tool and the axis that it carries, one of the table the axis that it carries.
BelievedMachine believed_machine(const Parameters& parameters,
                                 const machine::AxisChainSetup& sheet);

}  // namespace g31::fanuc

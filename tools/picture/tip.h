#pragma once

#include "machine/units/point.h"
#include "tools/setup/job.h"

namespace g31::picture {

/// What a picture follows: mm, from the spindle gauge point at spindle angle 0 to the centre of the
/// stylus ball; without a probe the gauge point itself.
Point tip_of(const setup::Job& job);

/// mm, from there to the point that pictures of another tool are told from: the lowest one on its
/// axis, of an insert the middle of its tip radius.
/// @pre a tool that is no probe
Point tip_of(const probe::ToolSetup& tool);

}  // namespace g31::picture

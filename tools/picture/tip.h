#pragma once

#include "machine/units/point.h"
#include "tools/setup/job.h"

namespace g31::picture {

/// What a picture follows: mm, from the spindle gauge point at spindle angle 0 to the centre of the
/// stylus ball; without a probe the gauge point itself.
Point tip_of(const setup::Job& job);

}  // namespace g31::picture

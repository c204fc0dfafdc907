#pragma once

#include <string>

#include "interpreter/runtime/control_setup.h"
#include "parts/artefacts/part_setup.h"

namespace g31::setup {

/// Takes place and rotation of a part as those in a work offset, and makes them those on the
/// machine: EXT, then the offset, each with its fine shift and its rotation.  Scale and mirror move
/// no part, and rotary axes of offsets turn none.
/// @pre the control has the offset
void put_on_offset(parts::PartSetup& part, const runtime::ControlSetup& control,
                   const std::string& offset);

}  // namespace g31::setup

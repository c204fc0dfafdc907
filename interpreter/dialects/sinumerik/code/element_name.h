#pragma once

#include <cstdint>
#include <string>

#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::sinumerik {

/// An element of a variable as programs write it: "R5", "_OVR[0]", "$MA_MAX_AX_ACCEL[X]",
/// "TABLE[1,2]"; of a variable without dimensions its name.
/// @param element  counted along the rows
std::string element_name(const Variable& variable, std::int32_t element);

}  // namespace g31::sinumerik

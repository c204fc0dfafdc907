#pragma once

#include <vector>

#include "interpreter/runtime/input_scripts.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// What [[input]] says, and the input that tells of a low battery.
/// @param errors  gets an [[input]] without a number or with two beginnings, and one that the probe
///                sets as well
std::vector<runtime::InputStep> inputs_from(const Sheet& sheet, ErrorList& errors);

}  // namespace g31::setup

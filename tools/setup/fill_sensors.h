#pragma once

#include "tools/setup/job.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// What [[sensor]] says: the sensors, and the words in which a control with such shows them.
/// @param errors  gets two sensors with one name, input or word
void fill_sensors(Job& job, const Sheet& sheet, ErrorList& errors);

}  // namespace g31::setup

#pragma once

#include <vector>

#include "interpreter/runtime/control_setup.h"
#include "probe/sensor/displacement_sensors.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// What [[sensor]] says.
/// @param errors  gets two sensors with one name, input or word
std::vector<probe::DisplacementSetup> sensors_from(const Sheet& sheet, ErrorList& errors);

/// The same as a control with words for inputs sees it.
std::vector<runtime::SensorWord> sensor_words_from(const Sheet& sheet, ErrorList& errors);

}  // namespace g31::setup

#pragma once

#include <optional>
#include <string_view>

#include "probe/sensor/probe_setup.h"

namespace g31::setup {

/// "M80", "#1103" or "$A_OUT[3]"; nullopt for anything else, and for numbers that no control has.
std::optional<probe::ProgramSwitch> program_switch(std::string_view text);

}  // namespace g31::setup

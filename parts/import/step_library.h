#pragma once

#include <string>

#include "machine/base/module.h"

namespace g31::parts {

/// A function of the module g31_step, or what is wrong and what to install.
ModuleFunction find_in_step_library(const std::string& name);

}  // namespace g31::parts

#pragma once

#include <string>
#include <variant>

#include "interpreter/runtime/cell.h"

namespace g31::runtime {

/// The value of a variable as reports show it: a number, vacant, or a text.
using ShownValue = std::variant<Cell, std::string>;

}  // namespace g31::runtime

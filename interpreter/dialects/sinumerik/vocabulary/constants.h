#pragma once

#include <span>
#include <string_view>

#include "interpreter/dialects/sinumerik/vocabulary/value_type.h"

namespace g31::sinumerik {

/// One row of constants.def.
struct ConstantInfo {
  std::string_view name;
  Type type;
  double value;
  std::string_view text;
};

std::span<const ConstantInfo> constants();

/// @param name  upper case
/// @returns nullptr: it is none
const ConstantInfo* find_constant(std::string_view name);

}  // namespace g31::sinumerik

#pragma once

#include <span>
#include <string_view>

#include "interpreter/dialects/sinumerik/vocabulary/op_code.h"

namespace g31::sinumerik {

/// One row of operators.def.
struct OperatorInfo {
  std::string_view name;
  int level;  ///< the higher, the closer it binds
  OpCode code;
  std::string_view text;
};

std::span<const OperatorInfo> operators();

}  // namespace g31::sinumerik

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "interpreter/dialects/sinumerik/vocabulary/op_code.h"

namespace g31::sinumerik {

/// Which operands an operator takes, and what it makes of them.
enum class OperatorKind : std::uint8_t { Comparison, Join, Logic, Bits, Arithmetic, Chain };

/// One row of operators.def.
struct OperatorInfo {
  std::string_view name;
  int level;  ///< the higher, the closer it binds
  OperatorKind kind;
  OpCode code;
  std::string_view text;
};

std::span<const OperatorInfo> operators();

}  // namespace g31::sinumerik

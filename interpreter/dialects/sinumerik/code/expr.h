#pragma once

#include <algorithm>
#include <cstdint>

#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::sinumerik {

/// What an expression or a part of one turned out to be.
struct Expr {
  Type type = Type::None;
  Operand value;
  ShortSpan where;
  std::int32_t variable = -1;  ///< it is this variable or an element of it
  Operand element;             ///< number of that element
  bool is_whole_array = false;
  bool is_constant = false;
};

/// From the beginning of one to the end of the other.
inline ShortSpan joined(ShortSpan first, ShortSpan last) {
  return {std::min(first.begin, last.begin), std::max(first.end, last.end)};
}

}  // namespace g31::sinumerik

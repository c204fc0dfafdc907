#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::analysis {

/// Comparisons that most likely are to hold before AND, OR, XOR or NOT joins them, the first of
/// each block: the control reads `a == 0 AND b == 0` as `(a == (0 AND b)) == 0` and `NOT a == 3` as
/// `(NOT a) == 3`, for comparisons bind less than these (programming manual NC, priority of
/// operators).  Told are comparisons of what a comparison with AND gave, of AND with a written
/// number, and of AND or NOT with one; 0 and 1 may be truths.
/// @return steps, ascending
std::vector<std::int32_t> mixed_comparisons(const sinumerik::CompiledProgram& program);

}  // namespace g31::analysis

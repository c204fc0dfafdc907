#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::analysis {

/// Comparisons of what a comparison with AND, OR or XOR gave, the first of each block: the control
/// reads `a == 0 AND b == 0` as `(a == (0 AND b)) == 0`, for comparisons bind less than these
/// (programming manual NC, priority of operators).
/// @return steps, ascending
std::vector<std::int32_t> mixed_comparisons(const sinumerik::CompiledProgram& program);

}  // namespace g31::analysis

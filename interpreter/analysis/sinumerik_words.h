#pragma once

#include <cstdint>
#include <map>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/value_limits.h"

namespace g31::analysis {

/// What ends every run of a step, by the step's number: constants that do not go where they are to
/// stand, in expressions and in the words of NC blocks.
using WrongSteps = std::map<std::int32_t, sinumerik::WrongValue>;
WrongSteps wrong_steps(const sinumerik::CompiledProgram& program);

}  // namespace g31::analysis

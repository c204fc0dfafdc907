#pragma once

#include <optional>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/value_limits.h"

namespace g31::analysis {

/// What ends every run of a step, because its operands are constants that do not go there: a text
/// longer than its variable, a number beyond INT, CHAR or LLI and ULI, an index that the array has
/// not, a division by 0.  nullopt: nothing, or only a run knows.
std::optional<sinumerik::WrongValue> wrong_constant(const sinumerik::CompiledProgram& program,
                                                    const sinumerik::Op& step);

}  // namespace g31::analysis

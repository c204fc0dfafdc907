#pragma once

#include <string_view>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/globals.h"

namespace g31::sinumerik {

/// Whether a text names a variable that a program sees: "R1", "NAME", "NAME[3,]",
/// "$P_UIFR[1,X,TR]". Brackets hold as many indices as the variable has, each one that it has, or
/// none.
bool names_variable(const Globals& globals, const CompiledProgram& program, std::string_view text);

}  // namespace g31::sinumerik

#pragma once

#include <cstdint>

#include "interpreter/analysis/flow_builder.h"
#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::analysis {

/// Adds the motion that the words of the NC block in the steps [first, end) command, if they do.
/// Axis letters beside TRANS, G4, G25 and the like are data.
void add_moves(const sinumerik::CompiledProgram& program, std::int32_t first, std::int32_t end,
               FlowBuilder& builder);

}  // namespace g31::analysis

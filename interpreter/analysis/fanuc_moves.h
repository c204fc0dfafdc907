#pragma once

#include "interpreter/analysis/flow_builder.h"
#include "interpreter/dialects/fanuc/code/compile.h"

namespace g31::analysis {

/// Adds the motion that the words of an NC block command, if they do.  Axis letters of a macro call
/// are arguments, those beside G10, G04, G92 and the like data.
void add_moves(const fanuc::CompiledProgram& program, const syntax::Block& block,
               const fanuc::Profile& profile, FlowBuilder& builder);

}  // namespace g31::analysis

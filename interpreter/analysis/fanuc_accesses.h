#pragma once

#include "interpreter/analysis/flow_builder.h"
#include "interpreter/dialects/fanuc/code/compile.h"

namespace g31::analysis {

/// Adds the variables that a step reads and writes to the present block, in the order of the text,
/// what it writes last.  A computed number, #[...], is the variable "#[]"; its own variables are
/// read.
void add_accesses(const fanuc::CompiledProgram& program, const fanuc::Step& step,
                  FlowBuilder& builder);

}  // namespace g31::analysis

#pragma once

#include "interpreter/analysis/flow.h"
#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::analysis {

/// The picture of a SINUMERIK program.
Flow flow_of(const sinumerik::CompiledProgram& program);

}  // namespace g31::analysis

#pragma once

#include "interpreter/analysis/fanuc_words.h"
#include "interpreter/analysis/flow.h"
#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"

namespace g31::analysis {

/// The picture of a Fanuc program, compiled whole for a control.
Flow flow_of(const fanuc::CompiledProgram& program, const fanuc::Profile& profile,
             const WordReading& reading = {});

}  // namespace g31::analysis

#pragma once

#include <memory>

#include "interpreter/analysis/program_set.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/source/source_map.h"
#include "tools/session/control.h"

namespace g31::session {

/// Programs of a control that are looked at and never run; none is in the set yet.
/// @param sources  outlives the programs
/// @param setup    whose data programs may name
std::unique_ptr<analysis::ProgramSet> analysed_programs(const Control& control,
                                                        source::SourceMap& sources,
                                                        const runtime::ControlSetup& setup = {});

}  // namespace g31::session

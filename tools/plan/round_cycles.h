#pragma once

#include <string>
#include <string_view>

#include "probe/planning/inspection_plan.h"
#include "tools/plan/inspection_program.h"
#include "tools/setup/job.h"

namespace g31::plan {

/// Says of each round wall of a plan that no cycle of the control measures it where the control
/// does not know the probe as calibrated, or the cycle has no room.
/// @param job  of the sheet that the program runs with
void choose_cycles(const setup::Job& job, const ProgramOptions& options,
                   probe::InspectionPlan& plan);

/// The whole plan point by point.
/// @param why  said of each round wall that a cycle was to measure
/// @returns whether there was one
bool give_up_cycles(const std::string& why, probe::InspectionPlan& plan);

/// "O9010", "CYCLE977"
std::string_view cycle_of(ProgramLanguage language);

}  // namespace g31::plan

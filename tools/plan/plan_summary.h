#pragma once

#include <string>

#include "tools/plan/planned_part.h"

namespace g31::plan {

/// What was found, what is measured and what is not, and what the proof was, for a person.
/// @param folder  that has the plan
std::string plan_summary(const PlannedPart& planned, const std::string& folder);

}  // namespace g31::plan

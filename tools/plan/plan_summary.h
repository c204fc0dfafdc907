#pragma once

#include <string>

#include "tools/plan/planned_part.h"

namespace g31::plan {

/// What was found, what is measured and what is not, and what the proof was, for a person.
std::string plan_summary(const PlannedPart& planned);

}  // namespace g31::plan

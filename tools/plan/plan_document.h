#pragma once

#include <string>

#include "tools/plan/planned_part.h"

namespace g31::plan {

/// The document g31.plan/1.
std::string plan_document(const PlannedPart& planned);

}  // namespace g31::plan

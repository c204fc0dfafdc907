#pragma once

#include <string>

#include "tools/plan/planned_part.h"

namespace g31::plan {

/// The part from above as SVG: stock, features in a colour for each kind, numbered points, and the
/// way of the probe between them.
std::string plan_drawing(const PlannedPart& planned);

}  // namespace g31::plan

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/plan/planned_part.h"

namespace g31::plan {

/// What the drawing says, in the language of its readers.
struct DrawingWords {
  std::string title;
  std::function<std::string(parts::FeatureKind)> kind;
  std::string way;  ///< between the touches
  std::vector<std::string> facts;
};

/// The part from above as SVG: stock, features in a colour for each kind, numbered points, and the
/// way of the probe between them.
std::string plan_drawing(const PlannedPart& planned, const DrawingWords& words);

}  // namespace g31::plan

#pragma once

#include <string>
#include <string_view>

#include "tools/evaluate/evaluation.h"

namespace g31::evaluate {

/// A set-up sheet with the correction of an error: a pair of place and correction, the deviation
/// with its sign reversed, for every point of the curve.
/// @param error  "EYX" and so on
std::string compensation_sheet(std::string_view error, const Curve& deviations);

}  // namespace g31::evaluate

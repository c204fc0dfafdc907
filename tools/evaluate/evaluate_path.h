#pragma once

#include "machine/base/result.h"
#include "tools/evaluate/evaluate.h"

namespace g31::evaluate {

/// A recorded circle: `metrology::evaluate_circle`.
Result<Evaluation, DataError> evaluate_circle(const DataFile& file, const Request& request);

}  // namespace g31::evaluate

#pragma once

#include "machine/base/result.h"
#include "tools/evaluate/evaluate.h"

namespace g31::evaluate {

/// A recorded circle: `metrology::evaluate_circle`.
Result<Evaluation, DataError> evaluate_circle(const DataFile& file, const Request& request);

/// A recorded square: `metrology::evaluate_square`.
Result<Evaluation, DataError> evaluate_square(const DataFile& file, const Request& request);

/// Speed over time: `metrology::evaluate_speed`.
Result<Evaluation, DataError> evaluate_speed(const DataFile& file, const Request& request);

/// The end of a straight way against its target, and both scaled to another length.
Result<Evaluation, DataError> evaluate_diagonal(const DataFile& file, const Request& request);

}  // namespace g31::evaluate

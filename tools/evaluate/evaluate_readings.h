#pragma once

#include "machine/base/result.h"
#include "tools/evaluate/evaluate.h"

namespace g31::evaluate {

/// Two or three sensors along a work: motion and work told apart
/// (`metrology::separate_two_points`).
Result<Evaluation, DataError> evaluate_straightness(const DataFile& file, const Request& request);

/// Points of a plane, or rows of two-sensor readings, each along X at its own y; between the rows
/// the motion across is taken as straight.
Result<Evaluation, DataError> evaluate_flatness(const DataFile& file, const Request& request);

/// Two-sensor readings along a work on a lathe, once for every angle, and its diameters at both
/// ends.
Result<Evaluation, DataError> evaluate_cylindricity(const DataFile& file, const Request& request);

/// Approaches of targets: ISO 230-2 (`metrology::evaluate_positioning`).
Result<Evaluation, DataError> evaluate_positioning(const DataFile& file, const Request& request);

}  // namespace g31::evaluate

#pragma once

#include <string>

#include "machine/base/result.h"
#include "tools/evaluate/evaluate.h"
#include "tools/evaluate/recorded_path.h"

namespace g31::evaluate {

/// Whether a kind takes a path: one that a run's trace holds.
bool is_of_path(Kind kind);

/// What a path says.  Error: why it cannot be evaluated so, one line.
using PathEvaluation = Result<Evaluation, std::string>;

/// @param request  of a kind that takes a path
PathEvaluation evaluate_path(const RecordedPath& path, const Request& request);

/// A circle: `metrology::evaluate_circle`.
PathEvaluation evaluate_circle(const RecordedPath& path, const Request& request);

/// A square: `metrology::evaluate_square`.
PathEvaluation evaluate_square(const RecordedPath& path, const Request& request);

/// Speed over time: `metrology::evaluate_speed`.
PathEvaluation evaluate_speed(const RecordedPath& path, const Request& request);

/// The end of a straight way against its target, and both scaled to another length.
PathEvaluation evaluate_diagonal(const RecordedPath& path, const Request& request);

}  // namespace g31::evaluate

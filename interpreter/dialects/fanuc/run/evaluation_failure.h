#pragma once

#include "interpreter/dialects/fanuc/state/evaluate.h"
#include "interpreter/dialects/fanuc/state/failure.h"

namespace g31::fanuc {

/// Why the statement ends whose evaluation has failed.
[[gnu::cold]] inline Failure evaluation_failure(Evaluator& evaluator) {
  const auto fault = evaluator.take_fault();
  Failure failure;
  failure.id = fault->id;
  failure.where = fault->where;
  failure.detail = fault->detail;
  return failure;
}

}  // namespace g31::fanuc

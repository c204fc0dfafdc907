#pragma once

#include <exception>

#include "interpreter/runtime/budget_spent.h"

namespace g31::runtime {

/// Does the work of a runner.  A defect of ours ends the run at the block that met it, and so does
/// a budget that is spent within a block; what the run did so far is told.
/// @param on_budget, on_defect  what the dialect calls the end of such a run
template <typename Work, typename OnBudget, typename OnDefect>
auto guarded(const Work& work, const OnBudget& on_budget, const OnDefect& on_defect)
    -> decltype(work()) {
  try {
    return work();
  } catch (const BudgetSpent& spent) {
    return on_budget(spent);
  } catch (const std::exception& defect) {
    return on_defect(defect);
  }
}

}  // namespace g31::runtime

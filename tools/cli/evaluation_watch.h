#pragma once

#include <cstddef>
#include <optional>

#include "interpreter/runtime/time_budget.h"
#include "machine/port/work_watch.h"
#include "tools/cli/progress.h"

namespace g31::cli {

/// Stands beside an evaluation: ends it when its time is up or somebody interrupts, and shows a
/// person how many rows have been read, and then for how long it has evaluated them.
class EvaluationWatch final : public machine::WorkWatch {
 public:
  /// @param rows   about so many are looked at first
  /// @param shows  shows_progress()
  EvaluationWatch(runtime::TimeBudget& time, std::size_t rows, bool shows);

  /// @throws runtime::BudgetSpent  as the time has it
  void look() override;

 private:
  runtime::TimeBudget& time_;
  std::size_t rows_left_;
  bool shows_;
  std::optional<Progress> progress_;
};

}  // namespace g31::cli

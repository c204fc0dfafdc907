#pragma once

#include <string>
#include <vector>

#include "interpreter/runtime/block_watch.h"
#include "interpreter/runtime/budget_spent.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/outcome.h"

namespace g31::runtime {

/// Why a run ended before its program did, and where.
struct StopReason {
  Status status = Status::Alarm;
  /// Of the alarm; with Setup, Budget, Interrupted and Defect the DiagnosticId, unless `is_alarm`;
  /// with Collision below 0: no alarm.
  int number = 0;
  bool is_alarm = false;  ///< the control raises an alarm for what is wrong with the set-up
  std::string text;       ///< of the alarm
  std::string detail;
  std::string remedy;
  /// Where, the innermost first, at least one: its place is that of the block.
  std::vector<CallLevel> levels;
};

/// What is left of the run: its status, the alarm if it was one, and the message as its only
/// diagnostic.
Outcome outcome_of(StopReason reason);

/// How a run ends that its watch halts; @pre not Halt::Paused
Status status_of(BlockWatch::Halt halt);
source::DiagnosticId message_of(BlockWatch::Halt halt);

/// How a run ends whose block has found a budget spent, or was interrupted.
Status status_of(const BudgetSpent& spent);

}  // namespace g31::runtime

#pragma once

#include <optional>
#include <string>

#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/runtime/budget_watch.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/source/diagnostic.h"
#include "interpreter/source/location.h"
#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// Why a block could not be executed.
struct Failure {
  AlarmId id = AlarmId::AddressNotFound;
  syntax::ShortSpan where;  ///< empty: the whole block
  source::Location block;   ///< an earlier block that was executed late; no file: the present one
  std::string detail;
  runtime::Status status = runtime::Status::Alarm;
  /// 0: the row's own; macro alarms count from it; Setup and Budget: the DiagnosticId.
  int alarm_number = 0;
  std::string alarm_text;  ///< empty: the row's own
};

/// nullopt: the block was executed.
using MaybeFailure = std::optional<Failure>;

/// The end of a run whose budget is spent.
inline Failure budget_failure(runtime::BudgetWatch::Spent spent) {
  const bool by_blocks = spent == runtime::BudgetWatch::Spent::Blocks;
  Failure failure;
  failure.status = runtime::Status::Budget;
  failure.alarm_number = static_cast<int>(by_blocks ? source::DiagnosticId::BudgetBlocks
                                                    : source::DiagnosticId::BudgetTime);
  return failure;
}

}  // namespace g31::fanuc

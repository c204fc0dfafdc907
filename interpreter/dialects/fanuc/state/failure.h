#pragma once

#include <exception>
#include <optional>
#include <string>

#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/runtime/block_watch.h"
#include "interpreter/runtime/budget_spent.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/stop_report.h"
#include "interpreter/source/diagnostic.h"
#include "interpreter/source/location.h"
#include "interpreter/syntax/tree.h"
#include "machine/base/rare.h"

namespace g31::fanuc {

/// Why a block could not be executed.
struct Failure {
  AlarmId id = AlarmId::AddressNotFound;
  syntax::ShortSpan where;  ///< of the text whose block runs; empty: the whole block
  source::Location place;   ///< that, for everybody; not known: the whole block
  source::Location block;   ///< an earlier block that was executed late; not known: the present one
  std::uint64_t calls = 0;  ///< PathBlock::calls of that block; 0: the machine knows it
  std::string detail;
  runtime::Status status = runtime::Status::Alarm;
  /// 0: the row's own; macro alarms count from it; Setup, Budget, Interrupted and Defect: the
  /// DiagnosticId.
  int alarm_number = 0;
  std::string alarm_text;   ///< empty: the row's own
  bool broken_off = false;  ///< within a block: the machine may be in the middle of a motion
};

/// nullopt: the block was executed.
using MaybeFailure = Rare<Failure>;

/// The end of a run that its watch halts.
[[gnu::cold]] inline Failure halt_failure(runtime::BlockWatch::Halt halt) {
  Failure failure;
  failure.status = runtime::status_of(halt);
  failure.alarm_number = static_cast<int>(runtime::message_of(halt));
  return failure;
}

/// The end of a run whose block has spent a budget.
inline Failure budget_failure(const runtime::BudgetSpent& spent) {
  Failure failure;
  failure.status = runtime::status_of(spent);
  failure.alarm_number = static_cast<int>(spent.message());
  failure.detail = spent.detail();
  failure.broken_off = true;
  return failure;
}

/// The end of a run in which g31 itself is wrong.
inline Failure defect_failure(const std::exception& defect) {
  Failure failure;
  failure.status = runtime::Status::Defect;
  failure.alarm_number = static_cast<int>(source::DiagnosticId::Defect);
  failure.detail = defect.what();
  failure.broken_off = true;
  return failure;
}

}  // namespace g31::fanuc

#pragma once

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "interpreter/dialects/sinumerik/code/value_limits.h"
#include "interpreter/dialects/sinumerik/vocabulary/alarms.h"
#include "interpreter/runtime/block_watch.h"
#include "interpreter/runtime/budget_spent.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/stop_report.h"
#include "interpreter/source/diagnostic.h"
#include "interpreter/source/location.h"
#include "machine/base/rare.h"

namespace g31::sinumerik {

/// Why a block could not be executed.
struct Failure {
  AlarmId id = AlarmId::SyntaxInText;
  std::string detail;
  runtime::Status status = runtime::Status::Alarm;
  /// 0: the row's own; SETAL gives its number; with Setup, Budget, Interrupted and
  /// Defect: the DiagnosticId, unless `is_alarm`.
  int number = 0;
  std::string text;                            ///< empty: the row's own
  std::optional<source::Location> where = {};  ///< of another block than the running one
  std::uint64_t calls = 0;  ///< PathBlock::calls of that block; 0: as now, or the machine knows it
  bool broken_off = false;  ///< within a block: the machine may be in the middle of a motion
  bool is_alarm = false;    ///< with Setup: the control raises the alarm `id` for it
};

/// Alarm 12050 for one of U, V and W that the machine has not.
[[gnu::cold]] Failure no_such_axis(int axis);
/// Frames do not know U, V and W, nor an axis that is none.
[[gnu::cold]] Failure no_frame_of(int axis);

/// nullopt: all went well.
using MaybeFailure = Rare<Failure>;

[[gnu::cold]] inline Failure failure(AlarmId id, std::string detail = {}) {
  Failure reason;
  reason.id = id;
  reason.detail = std::move(detail);
  return reason;
}

/// Of a value that cannot stand where it stands.
[[gnu::cold]] inline Failure failure(WrongValue wrong) {
  return failure(wrong.id, std::move(wrong.detail));
}
inline MaybeFailure failure(std::optional<WrongValue> wrong) {
  return wrong ? MaybeFailure(failure(*std::move(wrong))) : std::nullopt;
}

/// The alarm of a control that is called a tool which the set-up sheet has not.
inline Failure missing_tool(std::string name) {
  Failure reason = failure(AlarmId::BadToolName, std::move(name));
  reason.status = runtime::Status::Setup;
  reason.is_alarm = true;
  return reason;
}

/// The end of a run that no alarm of the control tells, but a message of g31.
/// @param status  Setup, Budget, Interrupted or Defect
inline Failure message_failure(runtime::Status status, source::DiagnosticId message,
                               std::string detail = {}) {
  Failure reason;
  reason.status = status;
  reason.number = static_cast<int>(message);
  reason.detail = std::move(detail);
  return reason;
}

/// The end of a run whose block has spent a budget.
inline Failure budget_failure(const runtime::BudgetSpent& spent) {
  Failure reason = message_failure(runtime::status_of(spent), spent.message(), spent.detail());
  reason.broken_off = true;
  return reason;
}

/// The end of a run in which g31 itself is wrong.
inline Failure defect_failure(const std::exception& defect) {
  Failure reason =
      message_failure(runtime::Status::Defect, source::DiagnosticId::Defect, defect.what());
  reason.broken_off = true;
  return reason;
}

/// The end of a run that its watch halts.
inline Failure halt_failure(runtime::BlockWatch::Halt halt) {
  return message_failure(runtime::status_of(halt), runtime::message_of(halt));
}

}  // namespace g31::sinumerik

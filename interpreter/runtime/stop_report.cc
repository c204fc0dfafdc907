#include "interpreter/runtime/stop_report.h"

#include <utility>

#include <fmt/format.h>

#include "machine/base/contract.h"

namespace g31::runtime {
namespace {

source::Diagnostic message_of(const Alarm& alarm) {
  return {source::Severity::Error,
          std::to_string(alarm.number),
          alarm.where,
          alarm.detail.empty() ? alarm.text : fmt::format("{}: {}", alarm.text, alarm.detail),
          alarm.remedy,
          {}};
}

}  // namespace

Outcome outcome_of(StopReason reason) {
  Outcome outcome;
  outcome.status = reason.status;
  source::Diagnostic diagnostic;
  const bool is_message = reason.status == Status::Setup || reason.status == Status::Budget ||
                          reason.status == Status::Interrupted || reason.status == Status::Defect;
  if (is_message && !reason.is_alarm) {
    diagnostic = make_diagnostic(static_cast<source::DiagnosticId>(reason.number), reason.where,
                                 reason.detail);
  } else if (reason.status == Status::Collision && reason.number < 0) {
    diagnostic = make_diagnostic(source::DiagnosticId::CollisionStop, reason.where, reason.detail);
  } else {
    outcome.alarm = Alarm{reason.number, std::move(reason.text),   reason.where,
                          reason.detail, std::move(reason.remedy), reason.inside,
                          reason.calls};
    diagnostic = message_of(*outcome.alarm);
  }
  for (const CallSite& place : reason.inside) {
    diagnostic.notes.push_back({place.where, fmt::format("in {}", place.program)});
  }
  for (const CallSite& call : reason.calls) {
    diagnostic.notes.push_back({call.where, fmt::format("called from {}", call.program)});
  }
  outcome.diagnostics.push_back(std::move(diagnostic));
  return outcome;
}

Status status_of(BlockWatch::Halt halt) {
  return halt == BlockWatch::Halt::Stopped ? Status::Interrupted : Status::Budget;
}

Status status_of(const BudgetSpent& spent) {
  return spent.message() == source::DiagnosticId::Interrupted ? Status::Interrupted
                                                              : Status::Budget;
}

source::DiagnosticId message_of(BlockWatch::Halt halt) {
  switch (halt) {
    case BlockWatch::Halt::Blocks:
      return source::DiagnosticId::BudgetBlocks;
    case BlockWatch::Halt::Time:
      return source::DiagnosticId::BudgetTime;
    case BlockWatch::Halt::Stopped:
      return source::DiagnosticId::Interrupted;
    case BlockWatch::Halt::Paused:
      break;
  }
  contract_violated("a pause is no end", __FILE__, __LINE__);
}

}  // namespace g31::runtime

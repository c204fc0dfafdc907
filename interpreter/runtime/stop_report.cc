#include "interpreter/runtime/stop_report.h"

#include <algorithm>
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

using Levels = std::vector<CallLevel>;

/// Of the levels from the innermost to the first that shows its blocks.
std::vector<CallSite> hidden_places(Levels::const_iterator first, Levels::const_iterator shown) {
  std::vector<CallSite> places;
  for (; first != shown; ++first) {
    places.push_back({first->program, first->where});
    places.insert(places.end(), first->waiting.begin(), first->waiting.end());
  }
  return places;
}

}  // namespace

Outcome outcome_of(StopReason reason) {
  const auto shown = std::ranges::find_if(reason.levels, &CallLevel::is_shown);
  G31_EXPECTS(shown != reason.levels.end());
  const std::vector<CallSite> inside = hidden_places(reason.levels.begin(), shown);
  const std::vector<CallSite> calls = calls_behind({shown, reason.levels.end()});
  Outcome outcome;
  outcome.status = reason.status;
  source::Diagnostic diagnostic;
  const bool is_message = reason.status == Status::Setup || reason.status == Status::Budget ||
                          reason.status == Status::Interrupted || reason.status == Status::Defect;
  if (is_message && !reason.is_alarm) {
    diagnostic = make_diagnostic(static_cast<source::DiagnosticId>(reason.number), shown->where,
                                 reason.detail);
  } else if (reason.status == Status::Collision && reason.number < 0) {
    diagnostic = make_diagnostic(source::DiagnosticId::CollisionStop, shown->where, reason.detail);
  } else {
    outcome.alarm = Alarm{reason.number,
                          std::move(reason.text),
                          shown->where,
                          reason.detail,
                          std::move(reason.remedy),
                          inside,
                          calls,
                          shown->number};
    diagnostic = message_of(*outcome.alarm);
  }
  for (const CallSite& place : inside) {
    diagnostic.notes.push_back({place.where, fmt::format("in {}", place.program)});
  }
  for (const CallSite& call : calls) {
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

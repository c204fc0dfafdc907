#include <fmt/format.h>

#include "interpreter/dialects/fanuc/runner.h"

namespace g31::fanuc {

std::string Runner::name_of(const CompiledProgram& program) {
  return program.number == 0 ? std::string("the main program")
                             : fmt::format("O{:04}", program.number);
}

source::Location Runner::location(syntax::ShortSpan span) const {
  return {frames_.back().program->file, span.widened()};
}

source::Location Runner::location_of(const Frame& frame) const {
  const CompiledProgram& program = *frame.program;
  return {program.file, program.tree->blocks[program.steps[frame.current].block].span.widened()};
}

std::vector<runtime::CallSite> Runner::call_stack() const {
  std::vector<runtime::CallSite> calls;
  for (std::size_t i = frames_.size() - 1; i > 0; --i) {
    calls.push_back({name_of(*frames_[i - 1].program), location_of(frames_[i - 1])});
  }
  return calls;
}

Failure Runner::from_evaluation() {
  const auto fault = control_.evaluator.take_fault();
  Failure failure;
  failure.id = fault->id;
  failure.where = fault->where;
  failure.detail = fault->detail;
  return failure;
}

runtime::Outcome Runner::outcome_of(const Failure& failure) {
  runtime::Outcome outcome;
  outcome.status = failure.status;
  const bool has_place = failure.where.end > failure.where.begin;
  const source::Location present = has_place ? location(failure.where) : location_of(frame());
  const source::Location where = failure.block.file != nullptr ? failure.block : present;
  std::vector<source::Note> notes;
  for (const runtime::CallSite& call : call_stack()) {
    notes.push_back({call.where, fmt::format("called from {}", call.program)});
  }
  source::Diagnostic diagnostic;
  if (failure.status == runtime::Status::Setup || failure.status == runtime::Status::Budget) {
    diagnostic = make_diagnostic(static_cast<source::DiagnosticId>(failure.alarm_number), where,
                                 failure.detail);
  } else if (failure.status == runtime::Status::Collision && failure.alarm_number < 0) {
    diagnostic = make_diagnostic(source::DiagnosticId::CollisionStop, where, failure.detail);
  } else {
    const AlarmInfo& row = info(failure.id);
    runtime::Alarm alarm;
    alarm.number = failure.alarm_number != 0
                       ? failure.alarm_number
                       : number_of(failure.id, control_.profile.alarm_numbers);
    alarm.text = failure.alarm_text.empty() ? std::string(row.text) : failure.alarm_text;
    alarm.where = where;
    alarm.detail = failure.detail;
    alarm.remedy = row.remedy;
    alarm.calls = call_stack();
    diagnostic = {
        source::Severity::Error,
        std::to_string(alarm.number),
        where,
        alarm.detail.empty() ? alarm.text : fmt::format("{}: {}", alarm.text, alarm.detail),
        alarm.remedy,
        {}};
    outcome.alarm = std::move(alarm);
  }
  diagnostic.notes = std::move(notes);
  control_.diagnostics.push_back(std::move(diagnostic));
  return outcome;
}

}  // namespace g31::fanuc

#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/run/runner.h"
#include "interpreter/runtime/stop_report.h"

namespace g31::fanuc {

std::string Runner::name_of(const CompiledProgram& program) {
  return program.number == 0 ? std::string("the main program")
                             : fmt::format("O{:04}", program.number);
}

source::Location Runner::location(syntax::ShortSpan span) const {
  return location_in(*frames_.back().program, span);
}

source::Location Runner::location_of(const Frame& frame) const {
  const CompiledProgram& program = *frame.program;
  return location_in(program, program.tree->blocks[program.steps[frame.current].block].span);
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
  const bool has_place = failure.where.end > failure.where.begin;
  const source::Location present = has_place ? location(failure.where) : location_of(frame());
  const AlarmInfo& row = info(failure.id);
  runtime::StopReason reason;
  reason.status = failure.status;
  reason.number = failure.alarm_number != 0 ? failure.alarm_number
                                            : number_of(failure.id, control_.profile.alarm_numbers);
  reason.text = failure.alarm_text.empty() ? std::string(row.text) : failure.alarm_text;
  reason.detail = failure.detail;
  reason.remedy = row.remedy;
  reason.where = failure.block.is_known() ? failure.block : present;
  reason.calls = call_stack();
  runtime::Outcome outcome = runtime::outcome_of(std::move(reason));
  control_.diagnostics.push_back(std::move(outcome.diagnostics.back()));
  outcome.diagnostics.clear();
  return outcome;
}

}  // namespace g31::fanuc

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/runner.h"

namespace g31::sinumerik {
namespace {

constexpr double kFirstAlarm = 60000.0;
constexpr double kLastAlarm = 69999.0;
constexpr std::size_t kMostTexts = 50'000;  // of EXECSTRING: what was compiled is kept

}  // namespace

/// A procedure's result goes to the variable that its argument names.
void Runner::set_result(const Argument& target, double value) {
  const Reference found = variable(target.variable);
  if (found.numbers != nullptr) {
    found.numbers[static_cast<std::size_t>(number(target.element))] = value;
  }
}

MaybeFailure Runner::procedure(const Op& op) {
  const Arguments list = arguments_of(op);
  switch (static_cast<ProcedureId>(op.detail)) {
    case ProcedureId::MSG:
      if (!list.empty()) {
        channel_.observer.on_message(text(list[0].value) + "\n");
      }
      return std::nullopt;
    case ProcedureId::SETAL:
      return set_alarm(list);
    case ProcedureId::EXECSTRING:
      return execute_text(text(list[0].value));
    case ProcedureId::WRITE:
    case ProcedureId::DELETE:
    case ProcedureId::READ:
    case ProcedureId::EXTOPEN:
    case ProcedureId::EXTWRITE:
    case ProcedureId::EXTCLOSE:
      file_procedure(static_cast<ProcedureId>(op.detail), list);
      return std::nullopt;
    case ProcedureId::SETMS:
      channel_.master_spindle = list.empty() ? 1.0 : number(list[0].value);
      return std::nullopt;
    case ProcedureId::GETSELT:
      set_result(list[0], channel_.selected_tool);
      return std::nullopt;
    case ProcedureId::GETEXET:
      set_result(list[0], channel_.tool);
      return std::nullopt;
    case ProcedureId::CALLPATH:
      channel_.call_path = list.empty() ? std::string() : text(list[0].value);
      found_calls_.clear();
      return std::nullopt;
    case ProcedureId::STOPRE:
      return finish_motion(channel_);
    case ProcedureId::FGROUP:
      return set_feed_axes(list);
    case ProcedureId::CHANDATA:
    case ProcedureId::WORKPIECE:
    case ProcedureId::GROUP_BEGIN:
    case ProcedureId::GROUP_END:
    case ProcedureId::DRFOF:
    case ProcedureId::STARTFIFO:
    case ProcedureId::STOPFIFO:
    case ProcedureId::FIFOCTRL:
    case ProcedureId::SBLON:
    case ProcedureId::SBLOF:
    case ProcedureId::DISPLON:
    case ProcedureId::DISPLOF:
    case ProcedureId::TRAFOOF:
    case ProcedureId::WAITS:
    case ProcedureId::WAITP:
    case ProcedureId::SPCON:
    case ProcedureId::SPCOF:
      // Each block waits for the one before: there is nothing to stop.
      return std::nullopt;
  }
  return std::nullopt;
}

/// The text sees the variables of the level; behind it the program goes on.
MaybeFailure Runner::execute_text(const std::string& source) {
  if (texts_run_.size() >= kMostTexts) {
    return failure(AlarmId::TooComplex, "EXECSTRING: too many different texts");
  }
  Level& now = level();
  const CompiledProgram*& made = texts_run_[{now.program, source}];
  if (made == nullptr) {
    made = library_.snippet(source, *now.program);
  }
  if (made->initial_numbers.size() != now.numbers.size() || !made->repeats.empty()) {
    return failure(AlarmId::BadArguments, "EXECSTRING: no definitions and no repetitions");
  }
  now.waiting.push_back({now.program, now.step, std::move(now.parts)});
  now.parts.clear();
  now.program = made;
  now.step = 0;
  use_level();
  return std::nullopt;
}

/// The machine counts F along the linear axes; rotary ones among them make no difference there.
MaybeFailure Runner::set_feed_axes(Arguments list) {
  std::size_t linear = 0;
  for (const Argument& axis : list) {
    linear += number(axis.value) < 3.0 ? 1U : 0U;
  }
  return list.empty() || linear == 3
             ? std::nullopt
             : std::optional(failure(AlarmId::NotImplemented, "FGROUP without X, Y or Z"));
}

/// SETAL(number, text): ends the program.
MaybeFailure Runner::set_alarm(Arguments list) {
  const double given = rounded(number(list[0].value));
  if (given < kFirstAlarm || given > kLastAlarm) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("SETAL({:.0f})", given));
  }
  Failure alarm = failure(AlarmId::CycleAlarm);
  alarm.number = static_cast<int>(given);
  alarm.text = list.size() > 1 ? text(list[1].value) : std::string();
  return alarm;
}

}  // namespace g31::sinumerik

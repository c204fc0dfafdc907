#include <array>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/run/runner.h"

namespace g31::sinumerik {
namespace {

constexpr double kFirstAlarm = 60000.0;
constexpr double kLastAlarm = 69999.0;
constexpr std::size_t kMostTexts = 50'000;  // of EXECSTRING: what was compiled is kept

}  // namespace

/// A procedure's result goes to the variable that its argument names, as an assignment would.
MaybeFailure Runner::set_result(const Argument& target, double value) {
  const Variable& into = level().program->variables[static_cast<std::size_t>(target.variable)];
  const Reference found = variable(target.variable);
  const auto kept = kept_as(found.type, value);
  if (!kept) {
    return failure(AlarmId::BadConversion,
                   fmt::format("{}: no {}", into.name, name_of(found.type)));
  }
  if (MaybeFailure wrong = beyond_limits(into, *kept)) {
    return wrong;
  }
  if (found.numbers != nullptr) {
    found.numbers[static_cast<std::size_t>(number(target.element))] = *kept;
  }
  return std::nullopt;
}

MaybeFailure Runner::procedure(const Op& op) {
  const Arguments list = arguments_of(op);
  switch (op.detail) {
    case static_cast<int>(ProcedureId::MSG):
      if (!list.empty()) {
        channel_.observer.on_message(text(list[0].value) + "\n");
      }
      return std::nullopt;
    case static_cast<int>(ProcedureId::SETAL):
      return set_alarm(list);
    case static_cast<int>(ProcedureId::EXECSTRING):
      return execute_text(text(list[0].value));
    case static_cast<int>(ProcedureId::WRITE):
    case static_cast<int>(ProcedureId::DELETE):
    case static_cast<int>(ProcedureId::READ):
    case static_cast<int>(ProcedureId::EXTOPEN):
    case static_cast<int>(ProcedureId::EXTWRITE):
    case static_cast<int>(ProcedureId::EXTCLOSE):
      return file_procedure(static_cast<ProcedureId>(op.detail), list);
    case static_cast<int>(ProcedureId::SETMS):
      channel_.master_spindle = list.empty() ? 1.0 : number(list[0].value);
      return std::nullopt;
    case static_cast<int>(ProcedureId::GETSELT):
      return set_result(list[0], channel_.selected_tool);
    case static_cast<int>(ProcedureId::GETEXET):
      return set_result(list[0], channel_.tool);
    case static_cast<int>(ProcedureId::DELT):
      return delete_tool(list);
    case static_cast<int>(ProcedureId::TCA):
      return select_named_tool(list);
    case static_cast<int>(ProcedureId::CALLPATH):
      channel_.call_path = list.empty() ? std::string() : text(list[0].value);
      found_calls_.clear();
      return std::nullopt;
    case static_cast<int>(ProcedureId::STOPRE):
      return finish_motion(channel_);
    case static_cast<int>(ProcedureId::FGROUP):
      return set_feed_axes(list);
    default:
      return std::nullopt;  // nothing to do here: each block waits for the one before
  }
}

/// The text sees the variables of the level; behind it the program goes on.
MaybeFailure Runner::execute_text(const std::string& source) {
  if (texts_run_.size() >= kMostTexts) {
    return failure(AlarmId::TooComplex, "EXECSTRING: too many different texts");
  }
  Level& now = level();
  const CompiledProgram*& made = texts_run_[{now.program, source}];
  if (made == nullptr) {
    made = programs_.snippet(source, *now.program);
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

/// FGROUP(axis,...); without axes all linear ones.
MaybeFailure Runner::set_feed_axes(Arguments list) {
  AxisSettings& settings = channel_.axis_settings;
  std::array<bool, kAxisCount> counts = {list.empty(), list.empty(), list.empty()};
  for (const Argument& argument : list) {
    const double axis = argument.type == Type::Axis ? number(argument.value) : kNoAxis;
    if (axis < 0.0) {
      return failure(AlarmId::NotAnAxis, "FGROUP");
    }
    counts[static_cast<std::size_t>(axis)] = true;
  }
  settings.counts = counts;
  settings.counts_as_usual = false;
  return std::nullopt;
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

#include <array>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/run/runner.h"
#include "machine/base/contract.h"

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
  if (auto wrong = beyond_limits(into, *kept)) {
    return failure(wrong->id, std::move(wrong->detail));
  }
  if (found.numbers != nullptr &&
      !store(found, static_cast<std::size_t>(number(target.element)), *kept)) {
    return from_step();
  }
  return std::nullopt;
}

MaybeFailure Runner::procedure(const Op& op) {
  const Arguments list = arguments_of(op);
  switch (static_cast<ProcedureId>(op.detail)) {
#define Done(f) return f(list)
#define RunsText(f) return f(list)
#define Reports(f) return set_result(list[0], f(list))
#define Writes(f) Reports(f)
#define Nothing() return std::nullopt
#define PROCEDURE(name, parameters, work, form, text) \
  case ProcedureId::name:                             \
    work;
#include "interpreter/dialects/sinumerik/vocabulary/procedures.def"
#undef PROCEDURE
#undef Nothing
#undef Writes
#undef Reports
#undef RunsText
#undef Done
  }
  contract_violated("every procedure has a row", __FILE__, __LINE__);
}

/// MSG(text)
MaybeFailure Runner::message(Arguments list) {
  if (!list.empty()) {
    channel_.message = text(list[0].value);
    channel_.observer.on_message({channel_.message + "\n", here()});
  }
  return std::nullopt;
}

MaybeFailure Runner::set_master_spindle(Arguments list) {
  channel_.master_spindle = list.empty() ? 1.0 : number(list[0].value);
  return std::nullopt;
}

MaybeFailure Runner::set_call_path(Arguments list) {
  channel_.call_path = list.empty() ? std::string() : text(list[0].value);
  found_calls_.clear();
  return std::nullopt;
}

MaybeFailure Runner::stop_reading_ahead(Arguments /*list*/) {
  if (MaybeFailure wrong = finish_motion(channel_)) {
    return wrong;
  }
  channel_.observer.on_standstill(here());
  return std::nullopt;
}

/// EXECSTRING(text): it sees the variables of the level; behind it the program goes on.
MaybeFailure Runner::execute_string(Arguments list) {
  const std::string& source = text(list[0].value);
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
    if (!is_machine_axis(static_cast<int>(axis))) {
      return failure(AlarmId::NotImplemented,
                     fmt::format("FGROUP({}): F counts along X, Y, Z, A, B and C alone",
                                 letter_of_axis(static_cast<int>(axis))));
    }
    counts[static_cast<std::size_t>(axis)] = true;
  }
  settings.counts = counts;
  settings.counts_as_usual = false;
  return std::nullopt;
}

/// TRAILON(axis, leading axis, factor): the same pair again has another factor.
MaybeFailure Runner::couple_axis(Arguments list) {
  const int follows = static_cast<int>(number(list[0].value));
  const int leads = static_cast<int>(number(list[1].value));
  if (!is_machine_axis(leads) || follows == leads ||
      (!is_machine_axis(follows) && !is_further_axis(follows))) {
    return failure(AlarmId::BadAxisIndex, "TRAILON: X, Y, Z, A, B or C leads another axis");
  }
  if (is_further_axis(follows) && channel_.further(follows) == nullptr) {
    return no_such_axis(follows);
  }
  const double factor = list.size() > 2 ? number(list[2].value) : 1.0;
  MaybeFailure wrong = finish_motion(channel_);
  channel_.couplings[{follows, leads}] = factor;
  return wrong;
}

/// TRAORI(n): the first transformation without n.
MaybeFailure Runner::transformation_on(Arguments list) {
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (number(list[i].value) != 0.0) {
      return failure(AlarmId::NotImplemented, "TRAORI: tool direction and axis offsets");
    }
  }
  return switch_transformation_on(channel_,
                                  list.empty() ? 1 : static_cast<int>(number(list[0].value)));
}

MaybeFailure Runner::transformation_off(Arguments /*list*/) {
  return switch_transformation_off(channel_);
}

/// ORIRESET(a, b)
MaybeFailure Runner::reset_orientation(Arguments list) {
  std::array<std::optional<double>, 2> deg;
  for (std::size_t i = 0; i < std::min(list.size(), deg.size()); ++i) {
    deg.at(i) = number(list[i].value);
  }
  return turn_back(channel_, deg, here());
}

/// TRAILOF(axis, leading axis), TRAILOF(axis)
MaybeFailure Runner::release_axis(Arguments list) {
  const int follows = static_cast<int>(number(list[0].value));
  const int leads = list.size() > 1 ? static_cast<int>(number(list[1].value)) : -1;
  MaybeFailure wrong = finish_motion(channel_);
  std::erase_if(channel_.couplings, [&](const auto& row) {
    return row.first.first == follows && (leads < 0 || row.first.second == leads);
  });
  return wrong;
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

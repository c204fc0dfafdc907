#include <array>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/run/procedures.h"
#include "interpreter/dialects/sinumerik/state/kinematic_chain.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/source/latin_1.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

MaybeFailure set_locked(SynchronisedActions& actions, Operands& at, Arguments list, bool locked) {
  if (!actions.is_acting()) {
    return failure(outside_of_action(locked ? ProcedureId::LOCK : ProcedureId::UNLOCK));
  }
  for (const Argument& argument : list) {
    actions.set_locked(static_cast<int>(at.number(argument)), locked);
  }
  return std::nullopt;
}

}  // namespace

MaybeFailure ProcedureCaller::call(const Op& op) {
  const Arguments list = operands_.arguments_of(op);
  switch (static_cast<ProcedureId>(op.detail)) {
#define Done(f) return done(procedure::f, list)
#define RunsText(f) return done(procedure::f, list)
#define Reports(f) return operands_.assign(list[0], procedure::f(channel_, operands_, list))
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

MaybeFailure ProcedureCaller::done(MaybeFailure (*work)(Channel&, Operands&, Arguments),
                                   Arguments list) {
  return work(channel_, operands_, list);
}

MaybeFailure ProcedureCaller::done(MaybeFailure (*work)(Calls&, Operands&, Arguments),
                                   Arguments list) {
  return work(calls_, operands_, list);
}

MaybeFailure ProcedureCaller::done(MaybeFailure (*work)(Calls&, Channel&, Operands&, Arguments),
                                   Arguments list) {
  return work(calls_, channel_, operands_, list);
}

MaybeFailure ProcedureCaller::done(MaybeFailure (*work)(SynchronisedActions&, Operands&, Arguments),
                                   Arguments list) {
  return work(actions_, operands_, list);
}

namespace procedure {

/// MSG(text)
MaybeFailure message(Channel& channel, Operands& at, Arguments list) {
  if (!list.empty()) {
    channel.message = at.text(list[0].value);
    channel.observer.on_message({channel.message + "\n", channel.here(), &source::text_as_utf8});
  }
  return std::nullopt;
}

MaybeFailure set_master_spindle(Channel& channel, Operands& at, Arguments list) {
  const double number = list.empty() ? 1.0 : at.number(list[0]);
  if (MaybeFailure wrong = failure(wrong_master_spindle(number))) {
    return wrong;
  }
  change_master(channel, static_cast<int>(number));
  return std::nullopt;
}

MaybeFailure stop_reading_ahead(Channel& channel, Operands& /*at*/, Arguments /*list*/) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  channel.observer.on_standstill(channel.here());
  return std::nullopt;
}

/// FGROUP(axis,...); without axes all linear ones.
MaybeFailure set_feed_axes(Channel& channel, Operands& at, Arguments list) {
  AxisSettings& settings = channel.axis_settings;
  std::array<bool, kAxisCount> counts = {list.empty(), list.empty(), list.empty()};
  for (const Argument& argument : list) {
    const double axis = argument.type == Type::Axis ? at.number(argument) : kNoAxis;
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

/// IPOBRKA(axis, percent)
MaybeFailure end_in_braking(Channel& channel, Operands& at, Arguments list) {
  const double axis = at.number(list[0]);
  if (axis < 0.0) {
    return failure(AlarmId::BadAxisIndex, "IPOBRKA");
  }
  channel.axis_settings.motion_end[static_cast<std::size_t>(axis)] = MotionEnd::Braking;
  return std::nullopt;
}

MaybeFailure diameters_by_channel(Channel& channel, Operands& /*at*/, Arguments /*list*/) {
  channel.axis_settings.diameter = {};
  return std::nullopt;
}

/// TRAILON(axis, leading axis, factor): the same pair again has another factor.
MaybeFailure couple_axis(Channel& channel, Operands& at, Arguments list) {
  const int follows = static_cast<int>(at.number(list[0]));
  const int leads = static_cast<int>(at.number(list[1]));
  if (!is_machine_axis(leads) || follows == leads ||
      (!is_machine_axis(follows) && !is_further_axis(follows))) {
    return failure(AlarmId::BadAxisIndex, "TRAILON: X, Y, Z, A, B or C leads another axis");
  }
  if (is_further_axis(follows) && channel.further(follows) == nullptr) {
    return no_such_axis(follows);
  }
  const double factor = list.size() > 2 ? at.number(list[2]) : 1.0;
  MaybeFailure wrong = finish_motion(channel);
  channel.couplings[{follows, leads}] = factor;
  return wrong;
}

/// TRAORI(n, x, y, z, a, b): the first transformation without n.  Machine data say which tool
/// carrier it takes, or themselves what it is.
MaybeFailure transformation_on(Channel& channel, Operands& at, Arguments list) {
  const auto value = [&](std::size_t i) {
    return i < list.size() && list[i].form != Argument::Form::Omitted ? at.number(list[i]) : 0.0;
  };
  const double number = value(0);
  BasicPosition basic;
  basic.direction = {value(1), value(2), value(3)};
  basic.offsets_deg = {value(4), value(5)};
  const auto carrier = channel.transformation_data.carrier_of(
      channel.numbers, number == 0.0 ? 1 : static_cast<int>(number));
  return carrier ? switch_transformation_on(channel, carrier.value(), basic)
                 : MaybeFailure(carrier.error());
}

/// TRAFOON(name)
MaybeFailure transformation_on_chain(Channel& channel, Operands& at, Arguments list) {
  const std::string name = at.text(list[0].value);
  const std::optional<int> number = transformation_named(channel, name);
  return number ? switch_transformation_on(channel, kFirstOnChain + *number, {})
                : failure(AlarmId::TransformationMissing, fmt::format("TRAFOON(\"{}\")", name));
}

/// NEWCONF
MaybeFailure activate_data(Channel& channel, Operands& /*at*/, Arguments /*list*/) {
  MaybeFailure wrong = transformation_is_unchanged(channel);
  if (!wrong) {
    channel.compensation_data.activate(channel);
  }
  return wrong;
}

MaybeFailure transformation_off(Channel& channel, Operands& /*at*/, Arguments /*list*/) {
  return switch_transformation_off(channel);
}

/// ORIRESET(a, b)
MaybeFailure reset_orientation(Channel& channel, Operands& at, Arguments list) {
  std::array<std::optional<double>, 2> deg;
  for (std::size_t i = 0; i < std::min(list.size(), deg.size()); ++i) {
    deg.at(i) = at.number(list[i]);
  }
  return turn_back(channel, deg, channel.here());
}

/// TRAILOF(axis, leading axis), TRAILOF(axis)
MaybeFailure release_axis(Channel& channel, Operands& at, Arguments list) {
  const int follows = static_cast<int>(at.number(list[0]));
  const int leads = list.size() > 1 ? static_cast<int>(at.number(list[1])) : -1;
  MaybeFailure wrong = finish_motion(channel);
  std::erase_if(channel.couplings, [&](const auto& row) {
    return row.first.first == follows && (leads < 0 || row.first.second == leads);
  });
  return wrong;
}

/// SETAL(number, text): ends the program, but for what is shown only.
MaybeFailure set_alarm(Channel& channel, Operands& at, Arguments list) {
  const double given = rounded(at.number(list[0]));
  if (MaybeFailure wrong = failure(wrong_alarm_number(given))) {
    return wrong;
  }
  const int number = static_cast<int>(given);
  const std::string text = list.size() > 1 ? at.text(list[1].value) : std::string();
  if (is_of_tolerance(number) || is_cleared_by_operator(number)) {
    channel.warnings.add(channel.diagnostics,
                         is_of_tolerance(number) ? source::DiagnosticId::OutOfTolerance
                                                 : source::DiagnosticId::AlarmShown,
                         channel.shown_block(), fmt::format("{} {}", number, text));
    return std::nullopt;
  }
  Failure alarm = failure(AlarmId::CycleAlarm);
  alarm.number = number;
  alarm.text = text;
  return alarm;
}

/// EXECSTRING(text)
MaybeFailure execute_string(Calls& calls, Operands& at, Arguments list) {
  return calls.execute_text(at.text(list[0].value));
}

MaybeFailure set_call_path(Calls& calls, Operands& at, Arguments list) {
  calls.set_call_path(list.empty() ? std::string() : at.text(list[0].value));
  return std::nullopt;
}

/// CANCEL(n,...)
MaybeFailure cancel_actions(SynchronisedActions& actions, Operands& at, Arguments list) {
  for (const Argument& argument : list) {
    actions.cancel(static_cast<int>(at.number(argument)));
  }
  return std::nullopt;
}

/// LOCK(n,...)
MaybeFailure lock_actions(SynchronisedActions& actions, Operands& at, Arguments list) {
  return set_locked(actions, at, list, true);
}

/// UNLOCK(n,...)
MaybeFailure unlock_actions(SynchronisedActions& actions, Operands& at, Arguments list) {
  return set_locked(actions, at, list, false);
}

/// RDISABLE
MaybeFailure disable_reading(SynchronisedActions& actions, Operands& /*at*/, Arguments /*list*/) {
  return actions.disable_reading();
}

}  // namespace procedure
}  // namespace g31::sinumerik

#include "interpreter/dialects/fanuc/state/control.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/state/believed_chain.h"
#include "interpreter/dialects/fanuc/state/expression_reads.h"
#include "interpreter/dialects/fanuc/state/pitch_errors.h"
#include "interpreter/dialects/fanuc/state/straightness.h"

namespace g31::fanuc {
namespace {

/// @param parameters, axes  must outlive the rules
EvaluationRules rules_of(const Profile& profile, const Parameters& parameters,
                         const std::string& axes) {
  EvaluationRules rules;
  const bool short_range =
      profile.has_series_30i_functions() && parameters.is_on(ParameterId::Range16i);
  rules.largest_result = short_range ? kLargestOf16i : profile.largest_result;
  rules.smallest_result = short_range ? kSmallestOf16i : profile.smallest_result;
  rules.digit_limit = profile.digit_limit;
  rules.signed_angles = parameters.is_on(ParameterId::SignedAngles);
  rules.has_signed_arc_sine = rules.signed_angles || profile.has_signed_arc_sine;
  rules.clear_small_sines = parameters.is_on(ParameterId::ClearSmallSines);
  rules.joins_conditions =
      profile.joins_conditions || parameters.is_on(ParameterId::JoinsConditions);
  rules.parameters = &parameters;
  rules.axes = &axes;
  rules.logic_operands = profile.logic_operands;
  return rules;
}

/// The rows that the control has: memories A and B take the place of C, and parameter 6000.3 turns
/// the numbers of C round, which leaves no room for the old work offset numbers (MB-122).
VariableGroups variable_groups(const Profile& profile, const Parameters& parameters,
                               OffsetMemory memory) {
  using enum VariableGroup;
  const VariableGroups groups = profile.variables;
  if (!groups.meets({OffsetsC})) {
    return groups;
  }
  switch (memory) {
    case OffsetMemory::A:
      return groups.without(OffsetsC).with(OffsetsA);
    case OffsetMemory::B:
      return groups.without(OffsetsC).with(OffsetsB);
    case OffsetMemory::C:
      break;
  }
  return parameters.is_on(ParameterId::OffsetsTurned)
             ? groups.without(OffsetsC).without(LegacyOffsets).with(OffsetsCTurned)
             : groups;
}

}  // namespace

Modal::Modal() {
  constexpr std::pair<Group, GNumber> kPowerOn[] = {{Group::Motion, {0, 0}},
                                                    {Group::Plane, {17, 0}},
                                                    {Group::Distance, {90, 0}},
                                                    {Group::StrokeCheck, {22, 0}},
                                                    {Group::FeedMode, {94, 0}},
                                                    {Group::Unit, {21, 0}},
                                                    {Group::CutterCompensation, {40, 0}},
                                                    {Group::ToolLength, {49, 0}},
                                                    {Group::CannedCycle, {80, 0}},
                                                    {Group::CycleReturn, {98, 0}},
                                                    {Group::Scaling, {50, 0}},
                                                    {Group::ModalCall, {67, 0}},
                                                    {Group::SpindleMode, {97, 0}},
                                                    {Group::WorkSystem, {54, 0}},
                                                    {Group::CuttingMode, {64, 0}},
                                                    {Group::Rotation, {69, 0}},
                                                    {Group::Polar, {15, 0}},
                                                    {Group::Mirror, {50, 1}},
                                                    {Group::DynamicOffset, {255, 0}}};
  for (const auto& [which, code] : kPowerOn) {
    group[which] = code;
  }
}

Control::Control(const Profile& chosen, machine::MachinePort& machine, runtime::Observer& listener,
                 SystemVariables& system)
    : profile(chosen),
      port(machine),
      observer(listener),
      outlet(machine, listener),
      system_variables(chosen.variables),
      all_variables(variables, system),
      evaluator(variables, all_variables, touches.missed,
                rules_of(chosen, parameters, controlled_axes)) {
  scale.excess_decimals = profile.excess_decimals;
  rapids.positioning = profile.rapids.positioning;
  if (profile.shifts_each_system) {
    coordinates.shift_each_system();
  }
  outlet.lead_by(coordinates.leader());
}

void Control::position_read() {
  if (!is_inspected()) {
    stopped_skip.reset();
    touches.looks();
  }
}

void Control::use_measured() {
  warnings_.add_missed(diagnostics, touches.missed.uses());
}

void Control::report_missed_touches() {
  constexpr std::size_t kFirstCall = 1;
  touches.missed.forget(holder_of(kFirstCall, kFirstLocal), ~runtime::MissedTouches::Holder{0});
  warnings_.add_missed(diagnostics, touches.missed.ends());
}

void Control::report_unread_miss() {
  warnings_.add_missed(diagnostics, touches.missed.breaks_off());
}

void Control::report_stopped_skip() {
  if (stopped_skip) {
    warn(source::DiagnosticId::ProtectedMoveStopped, *stopped_skip);
    stopped_skip.reset();
  }
}

void Control::report_read_ahead(const SystemVariable& row, std::int32_t number) {
  if (is_inspected()) {
    return;
  }
  const source::Location where = here();
  if (const auto report = lookahead.judge(row, where, number)) {
    diagnostics.push_back(make_diagnostic(*report, where, fmt::format("#{}", number)));
  }
}

void Control::warn(source::DiagnosticId id, source::Location where) {
  warnings_.add(diagnostics, id, where);
}

void Control::warn_of(const std::optional<machine::SensorState>& sensor, source::Location where) {
  warnings_.add_complaints(diagnostics, sensor, where);
}

void Control::tell_repeats() {
  warnings_.tell_repeats(diagnostics);
}

void Control::warn_once(source::DiagnosticId id, source::Location where, std::string_view detail) {
  if (warned_.emplace(id, detail).second) {
    diagnostics.push_back(make_diagnostic(id, where, detail));
  }
}

machine::BlockEnd Control::feed_end() const {
  constexpr int kNoExactStop = 4;
  const bool exact = stops_exactly || modal.group[Group::CuttingMode].whole == 61;
  return exact && (override_control & kNoExactStop) == 0 ? rapid_end() : machine::BlockEnd::PassOn;
}

machine::BlockEnd Control::rapid_end() const {
  return parameters.is_on(ParameterId::NoInPositionCheck) ? machine::BlockEnd::CommandStop
                                                          : machine::BlockEnd::ExactStop;
}

machine::ContourControl Control::contour_control() const {
  return rapids.contour_control || rapids.looks_ahead ? machine::ContourControl::FeedForward
         : profile.plans_ahead                        ? machine::ContourControl::LookAhead
                                                      : machine::ContourControl::Off;
}

machine::RapidPath Control::rapid_path() const {
  const bool contour_makes_straight =
      rapids.contour_control && !parameters.is_on(ParameterId::RapidsAsUsual);
  return contour_makes_straight || parameters.is_on(ParameterId::StraightRapids)
             ? machine::RapidPath::Straight
             : rapids.positioning;
}

void Control::apply(const Parameters& given) {
  const Parameters before = parameters;
  parameters = given;
  code_calls.turn_over(before, parameters, profile);
  evaluator.set_rules(rules_of(profile, parameters, controlled_axes));
  scale.calculator_point = parameters.is_on(ParameterId::CalculatorPoint);
  roll_over = RollOver(parameters);
  variables.protect(nearest_integer(parameters.get(ParameterId::FirstProtected)),
                    nearest_integer(parameters.get(ParameterId::LastProtected)));
  choose_system_variables();
  const bool is_inch = parameters.is_on(ParameterId::InchInput);
  if (is_inch != (scale.unit == LengthUnit::Inch)) {
    set_unit(is_inch ? LengthUnit::Inch : LengthUnit::Millimetre);
  }
  const BelievedMachine believed = believed_machine(parameters, sheet_kinematics_);
  if (believed.chain != coordinates.kinematics() ||
      believed.tool_at_rest.matrix() != coordinates.tool_at_rest().matrix()) {
    coordinates.set_kinematics(believed.chain, believed.tool_at_rest);
  }
}

MaybeFailure Control::tell_machine() {
  constexpr double kMmPerUnit = 0.001;
  constexpr double kSecondsPerMinute = 60.0;
  constexpr double kMsPerSecond = 1000.0;
  machine::AxisData told = of_machine_;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const double width = parameters.get_for_axis(ParameterId::InPositionWidth, 0, axis);
    if (width > 0.0) {
      told.stop_fine[axis] = kMmPerUnit * width;
    }
    const double jump = parameters.get_for_axis(ParameterId::CornerJump, 0, axis);
    if (jump > 0.0) {
      told.corner_jump_per_s[axis] = jump / kSecondsPerMinute;
    }
    const double time_ms = parameters.get_for_axis(ParameterId::FeedTimeConstant, 0, axis);
    told.filter_s[axis] = std::max(0.0, time_ms) / kMsPerSecond;
  }
  told.feed_filter = parameters.is_on(ParameterId::BellFilter) ? machine::FeedFilter::Bell
                     : parameters.is_on(ParameterId::LinearFilter)
                         ? machine::FeedFilter::Linear
                         : machine::FeedFilter::Exponential;
  port.set_axis_data(told);
  const auto straightness = straightness_tables(parameters);
  if (!straightness) {
    return straightness.error();
  }
  auto tables = pitch_error_tables(parameters);
  tables.insert(tables.end(), straightness.value().begin(), straightness.value().end());
  if (!tables.empty() || compensates_) {
    compensates_ = !tables.empty();
    port.compensate(tables);
  }
  return std::nullopt;
}

void Control::set_offset_memory(OffsetMemory memory) {
  offsets.set_memory(memory);
  choose_system_variables();
}

void Control::choose_system_variables() {
  system_variables = SystemVariableIndex(variable_groups(profile, parameters, offsets.memory()));
}

void Control::set_unit(LengthUnit unit) {
  modal.group[Group::Unit] = {static_cast<std::int16_t>(unit == LengthUnit::Inch ? 20 : 21), 0};
  scale.unit = unit;
  parameters.switch_to(ParameterId::InchInput, unit == LengthUnit::Inch);
}

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/control.h"

#include <utility>

namespace g31::fanuc {
namespace {

EvaluationRules rules_of(const Profile& profile, const Parameters& parameters) {
  EvaluationRules rules;
  rules.largest_result = profile.largest_result;
  rules.smallest_result = profile.smallest_result;
  rules.digit_limit = profile.digit_limit;
  rules.signed_angles = parameters.bit(6004, 0);
  rules.clear_small_sines = parameters.bit(6004, 1);
  rules.has_series_30i_functions = profile.has_series_30i_functions;
  return rules;
}

}  // namespace

Modal::Modal() {
  constexpr std::pair<int, GNumber> kPowerOn[] = {
      {1, {0, 0}},   {2, {17, 0}},  {3, {90, 0}},  {4, {22, 0}},  {5, {94, 0}},  {6, {21, 0}},
      {7, {40, 0}},  {8, {49, 0}},  {9, {80, 0}},  {10, {98, 0}}, {11, {50, 0}}, {12, {67, 0}},
      {13, {97, 0}}, {14, {54, 0}}, {15, {64, 0}}, {16, {69, 0}}, {17, {15, 0}}, {22, {50, 1}}};
  for (const auto& [number, code] : kPowerOn) {
    group[static_cast<std::size_t>(number)] = code;
  }
}

Control::Control(const Profile& chosen, machine::MachinePort& machine, runtime::Observer& listener,
                 SystemVariables& system)
    : profile(chosen),
      port(machine),
      observer(listener),
      variables(system),
      evaluator(variables, rules_of(chosen, {})) {
  scale.excess_decimals = profile.excess_decimals;
}

void Control::report_silent_skip() {
  if (silent_skip) {
    diagnostics.push_back(make_diagnostic(source::DiagnosticId::SkipWithoutSignal, *silent_skip));
    silent_skip.reset();
  }
}

void Control::warn_once(source::DiagnosticId id, source::Location where, std::string_view detail) {
  if (warned_.insert(id).second) {
    diagnostics.push_back(make_diagnostic(id, where, detail));
  }
}

void Control::apply(const Parameters& given) {
  parameters = given;
  evaluator.set_rules(rules_of(profile, parameters));
  scale.calculator_point = parameters.bit(3401, 0);
}

}  // namespace g31::fanuc

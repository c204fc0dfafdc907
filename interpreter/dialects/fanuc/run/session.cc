#include "interpreter/dialects/fanuc/run/session.h"

#include <charconv>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/run/inspector.h"
#include "interpreter/dialects/fanuc/run/runner.h"
#include "interpreter/dialects/fanuc/state/believed_chain.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"

namespace g31::fanuc {
namespace {

/// Which system "G54".."G59", "EXT", "G54.1 P1", "G154 P1" names, as Coordinates counts them.
std::optional<int> system_in_name(std::string_view name) {
  constexpr std::string_view kAdditional[] = {"G54.1 P", "G154 P"};
  if (name == "EXT") {
    return 0;
  }
  for (const std::string_view prefix : kAdditional) {
    if (!name.starts_with(prefix)) {
      continue;
    }
    const auto digits = name.substr(prefix.size());
    int p = 0;
    const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), p);
    const bool legal = end.ec == std::errc() && end.ptr == digits.data() + digits.size() &&
                       p >= 1 && p <= Coordinates::kAdditional;
    return legal ? std::optional(Coordinates::kSystems + p) : std::nullopt;
  }
  if (name.size() == 3 && name.starts_with("G5") && name[2] >= '4' && name[2] <= '9') {
    return name[2] - '3';
  }
  return std::nullopt;
}

/// The name that a sheet has for a system.
std::string name_of_system(int which, const Profile& profile) {
  return which == 0 ? std::string("EXT") : work_system_name(which, profile);
}

void tell_machine(Control& control, std::vector<runtime::RefusedSetting>& refused) {
  if (const MaybeFailure contradiction = control.tell_machine()) {
    refused.push_back({"parameters", contradiction->detail});
  }
}

std::vector<runtime::RefusedSetting> configure_offsets(Control& control,
                                                       const runtime::ControlSetup& setup) {
  std::vector<runtime::RefusedSetting> refused;
  for (const auto& [name, q_offset] : setup.work_offsets) {
    const auto system = system_in_name(name);
    if (!system) {
      refused.push_back({"work_offsets." + name,
                         fmt::format("work offset {}: this control has EXT, G54 to G59, {}n", name,
                                     control.profile.additional_system)});
      continue;
    }
    for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
      control.coordinates.set_system(*system, axis, q_offset[axis]);
    }
    control.expected_systems.insert(*system);
  }
  for (const auto& [number, entry] : setup.tools) {
    if (number < 1 || number > OffsetTable::kLargest) {
      refused.push_back(
          {fmt::format("tools.{}", number),
           fmt::format("tool {}: offset numbers are 1 to {}", number, OffsetTable::kLargest)});
      continue;
    }
    control.offsets.set(number, entry);
    control.expected_tools.insert(number);
  }
  return refused;
}

void configure_calls(Control& control, const runtime::ControlSetup& setup,
                     std::vector<runtime::RefusedSetting>& refused) {
  for (const auto& [code, program] : setup.macro_calls) {
    int number = 0;
    const auto end = std::from_chars(code.data() + 1, code.data() + code.size(), number);
    const bool known = code.size() >= 2 && (code[0] == 'G' || code[0] == 'M');
    if (!known || end.ptr != code.data() + code.size()) {
      refused.push_back({"macro_calls." + code,
                         fmt::format("macro call {}: write G or M and a whole number", code)});
      continue;
    }
    (code[0] == 'G' ? control.code_calls.macro_by_g : control.code_calls.macro_by_m)[number] =
        program;
  }
}

/// What a Haas has in its settings and others in parameters.
void take_parameter_settings(Control& control) {
  constexpr int kTableOfSettings = 20000;
  Parameters parameters = control.parameters;
  bool is_set = false;
  for (const ParameterSetting& row : control.profile.parameter_settings) {
    const auto setting = control.data.find(kTableOfSettings + row.setting);
    if (setting == control.data.end() || (setting->second == 0.0 && !row.takes_zero)) {
      continue;
    }
    const ParameterInfo& parameter = info(row.parameter);
    if (parameter.bit) {
      parameters.switch_to(row.parameter, true);
    } else {
      parameters.set_value(parameter.first + row.index, setting->second * row.counts);
    }
    is_set = true;
  }
  if (is_set) {
    control.apply(parameters);
  }
}

/// Whether the variable is the unit that lengths in others are in.
bool is_unit(const Control& control, std::optional<int> variable) {
  const SystemVariable* const row = variable ? control.system_variables.find(*variable) : nullptr;
  return row != nullptr && row->shows == Shows::UnitSetting;
}

void preset_variables(Control& control, const runtime::ControlSetup& setup,
                      std::vector<runtime::RefusedSetting>& refused) {
  const auto preset = [&control](std::optional<int> number, std::optional<double> value) {
    return number && !control.all_variables.preset(*number, value ? Cell(*value) : Cell());
  };
  for (const auto& [name, value] : setup.variables) {
    if (const auto number = variable_in_name(name); is_unit(control, number)) {
      preset(number, value);
    }
  }
  for (const auto& [name, value] : setup.variables) {
    const auto number = variable_in_name(name);
    if (number && is_local(*number) && setup.kept_variables.contains(name)) {
      refused.push_back(
          {"variables." + name,
           fmt::format("variable {}: a local variable, which no control keeps", name)});
    } else if (value && std::fabs(*value) > control.evaluator.largest_result()) {
      refused.push_back({"variables." + name,
                         fmt::format("variable {}: {} is beyond the numbers of this control, {}",
                                     name, *value, control.evaluator.largest_result())});
    } else if (!preset(number, value)) {
      refused.push_back(
          {"variables." + name, fmt::format("variable {}: cannot be set on this control", name)});
    }
  }
}

/// The codes in force when the control is switched on, where parameters choose others.
void choose_codes_at_start(Control& control) {
  struct Choice {
    ParameterId by;
    Group group;
    GNumber code;
  };
  // Of G18 and G19 the first one counts.
  constexpr Choice kChoices[] = {
      {ParameterId::StartsInFeed, Group::Motion, {1, 0}},
      {ParameterId::StartsInYz, Group::Plane, {19, 0}},
      {ParameterId::StartsInZx, Group::Plane, {18, 0}},
      {ParameterId::StartsIncremental, Group::Distance, {91, 0}},
      {ParameterId::StartsWithoutStrokeCheck, Group::StrokeCheck, {23, 0}},
  };
  for (const Choice& choice : kChoices) {
    if (control.parameters.is_on(choice.by)) {
      control.modal.group[choice.group] = choice.code;
    }
  }
}

/// Those that a sheet gives the machine and this control does not have.
void tell_unused_axes(Control& control, const runtime::ControlSetup& setup) {
  for (const auto& [letter, axis] : setup.further_axes) {
    control.diagnostics.push_back(
        make_diagnostic(source::DiagnosticId::UnusedAxis, {}, std::string(1, letter)));
    control.diagnostics.back().setting = fmt::format("machine.axes.{}", letter);
  }
}

/// Those that g31 does not have, or that change nothing.
void tell_unknown_parameters(Control& control, const runtime::ControlSetup& setup) {
  for (const auto& [name, value] : setup.parameters) {
    if (!has_effect(name)) {
      control.diagnostics.push_back(
          make_diagnostic(source::DiagnosticId::UnknownParameter, {}, name));
      control.diagnostics.back().setting = "parameters." + name;
    }
  }
}

}  // namespace

Session::Session(const Profile& profile, ProgramLibrary& library, machine::MachinePort& port,
                 runtime::Observer& observer)
    : runner_(std::make_unique<Runner>(profile, library, port, observer)),
      inspector_(std::make_unique<Inspector>(*runner_)) {
  library.compile_for(profile);
}

Session::~Session() = default;

std::vector<runtime::RefusedSetting> Session::configure(const runtime::ControlSetup& setup) {
  std::vector<runtime::RefusedSetting> refused;
  const auto given = Parameters::from(setup.parameters);
  if (!given) {
    refused.push_back(
        {"parameters." + given.error(),
         fmt::format("parameter {}: write NUMBER, NUMBER.BIT or NUMBER.AXIS", given.error())});
    return refused;
  }
  Control& control = runner_->control();
  tell_unknown_parameters(control, setup);
  Parameters parameters = given.value();
  parameters.set_reference(setup.q_M_reference);
  fill_kinematics(parameters, setup.kinematics);
  control.take_kinematics(setup.kinematics);
  control.apply(parameters);
  choose_codes_at_start(control);
  tell_unused_axes(control, setup);
  if (!setup.increment.empty()) {
    control.scale.set_increment_system(setup.increment);
  }
  if (!setup.axes.empty()) {
    control.controlled_axes = setup.axes;
  }
  control.set_offset_memory(setup.offset_memory);
  control.block_skip = setup.block_skip;
  control.feed_switches = setup.feed_switches;
  control.rapids.positioning = setup.rapids.value_or(control.profile.rapids.positioning);
  control.inputs = runtime::InputScripts(setup.inputs);
  control.keys_left = setup.keys;
  control.sensor_words = setup.sensor_words;
  control.lookahead.set_depth(setup.lookahead_blocks);
  refused = configure_offsets(control, setup);
  tell_machine(control, refused);
  for (const auto& [name, datum] : setup.data) {
    refused.push_back({"data." + name, "machine data and user data are of SINUMERIK"});
  }
  for (const auto& [name, shape] : setup.offset_shapes) {
    refused.push_back({"work_offsets." + name,
                       "rotate_deg, fine, scale and mirror of a work offset are of SINUMERIK"});
  }
  configure_calls(control, setup, refused);
  preset_variables(control, setup, refused);
  take_parameter_settings(control);
  return refused;
}

void Session::connect(runtime::PrinterPort& printer) {
  runner_->control().printer = &printer;
}

runtime::Outcome Session::run(const runtime::Budget& budget) {
  begin(budget, nullptr);
  advance();
  return finish();
}

void Session::begin(const runtime::Budget& budget, runtime::BlockListener* listener) {
  runner_->begin(budget, listener);
}

runtime::Advance Session::advance() {
  return runner_->advance();
}

runtime::Outcome Session::finish() {
  return runner_->finish();
}

std::unique_ptr<runtime::Keyframe> Session::keyframe() const {
  return std::make_unique<runtime::KeptState<ControlState>>(runner_->control());
}

std::vector<runtime::CallLevel> Session::call_levels() const {
  return runner_->call_levels();
}

runtime::NamedValues Session::values(std::size_t level, runtime::Scope scope) {
  return inspector_->values(level, scope);
}

Result<runtime::Cell, std::string> Session::evaluate(std::size_t level, const std::string& text) {
  return inspector_->evaluate(level, text);
}

Result<Cell, std::string> Session::variable(const std::string& name) {
  const auto number = variable_in_name(name);
  if (!number) {
    return fmt::format("{} is not a variable of this control: write # and a number", name);
  }
  const runtime::LookFromOutside look(runner_->control().touches);
  const auto value = runner_->control().all_variables.read(*number);
  if (!value) {
    return fmt::format("{} cannot be read on this control", name);
  }
  return value.value();
}

std::optional<double> Session::work_offset(const std::string& name, int axis) const {
  const auto system = system_in_name(name);
  return system ? std::optional(runner_->control().coordinates.system(*system)[axis])
                : std::nullopt;
}

std::map<std::string, runtime::TableValue> Session::tables() const {
  const Control& control = runner_->control();
  std::map<std::string, runtime::TableValue> table;
  const auto add = [&](const std::string& name, double value) {
    if (value != 0.0) {
      table.emplace(name, runtime::TableValue{value});
    }
  };
  for (int which = 0; which <= Coordinates::kSystems + Coordinates::kAdditional; ++which) {
    const AxisPositions& q_M = control.coordinates.system(which);
    for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
      add(fmt::format("work_offsets.{}.{}", name_of_system(which, control.profile),
                      kAxisLetters[static_cast<std::size_t>(axis)]),
          q_M[axis]);
    }
  }
  for (int number = 1; number <= OffsetTable::kLargest; ++number) {
    if (control.offsets.has(number)) {
      const runtime::ToolEntry entry = control.offsets.get(number);
      add(fmt::format("tools.{}.length", number), entry.length_mm);
      add(fmt::format("tools.{}.length_wear", number), entry.length_wear_mm);
      add(fmt::format("tools.{}.radius", number), entry.radius_mm);
      add(fmt::format("tools.{}.radius_wear", number), entry.radius_wear_mm);
    }
  }
  return table;
}

std::map<std::string, double> Session::permanent_variables() const {
  std::map<std::string, double> kept;
  for (const auto& [name, value] : common_values(runner_->control(), kFirstPermanent)) {
    kept.emplace(name, std::get<runtime::Cell>(value).raw());
  }
  return kept;
}

}  // namespace g31::fanuc

#include "interpreter/dialects/sinumerik/run/session.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/element_name.h"
#include "interpreter/dialects/sinumerik/code/sheet_data.h"
#include "interpreter/dialects/sinumerik/run/runner.h"
#include "interpreter/dialects/sinumerik/state/kinematic_chain.h"

namespace g31::sinumerik {
namespace {

/// "G54" is settable frame 1, "G505" 5, "G500" 0.
std::optional<int> settable_in_name(const std::string& name) {
  const auto code = find_g_code(name);
  if (!code || g_codes()[code->row].group != Group::SettableFrame) {
    return std::nullopt;
  }
  return g_codes()[code->row].number + code->beyond - 1;
}

Frame shifted(const AxisPositions& q) {
  Frame frame;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    frame.set_component(axis, Component::Coarse, q[axis]);
  }
  return frame;
}

void take_shape(Frame& frame, const runtime::OffsetShape& shape) {
  frame.set_angles({shape.rotate_deg.at(0), shape.rotate_deg.at(1), shape.rotate_deg.at(2)});
  for (int axis = 0; axis < static_cast<int>(kLinearAxisCount); ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    frame.set_component(axis, Component::Fine, shape.fine_mm.at(at));
    frame.set_component(axis, Component::Scale, shape.scale.at(at));
    const bool is_mirrored = shape.mirrored.find(kAxisLetters[at]) != std::string::npos;
    frame.set_component(axis, Component::Mirror, is_mirrored ? 1.0 : 0.0);
  }
}

/// A line of the tool table as edge D1.
EdgeData edge_from(const runtime::ToolEntry& entry) {
  EdgeData edge = {};
  edge[EdgeDatum::kType] = entry.type;
  edge[EdgeDatum::kLength1] = entry.length_mm;
  edge[EdgeDatum::kRadius] = entry.radius_mm;
  edge[EdgeDatum::kWear1] = entry.length_wear_mm;
  edge[EdgeDatum::kRadiusWear] = entry.radius_wear_mm;
  return edge;
}

/// The first tool carrier is what the control believes of the machine's rotary axes.
void configure_carrier(Channel& channel, const runtime::ControlSetup& setup) {
  const auto vectors = machine::vectors_of(setup.kinematics);
  if (!vectors) {
    return;
  }
  std::array<machine::RotaryTravel, 2> travel;
  for (std::size_t i = 0; i < 2; ++i) {
    const int axis = vectors->axes.at(i);
    if (const auto goes = axis >= 0 ? channel.port.travel(axis) : std::nullopt) {
      travel.at(i) = {goes->min, goes->max};
    }
  }
  channel.carriers[1] = carrier_of(*vectors, travel);
  channel.transformation_data.take(vectors->axes, channel.numbers);
  fill_chain(channel, *vectors);
}

/// Soft limits and data of the sheet.
void configure_data(Runner& runner, const runtime::ControlSetup& setup,
                    std::vector<runtime::RefusedSetting>& refused) {
  /// Text of an assignment, and the key that it is of.
  std::vector<std::pair<std::string, std::string>> assignments;
  for (const auto& [axis, limits] : setup.q_M_travel) {
    const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
    const std::string key = fmt::format("machine.axes.{}", letter);
    assignments.emplace_back(
        fmt::format("$MA_POS_LIMIT_MINUS[{}]={}", letter, written_number(limits.first)), key);
    assignments.emplace_back(
        fmt::format("$MA_POS_LIMIT_PLUS[{}]={}", letter, written_number(limits.second)), key);
  }
  if (!setup.axes.empty()) {
    refused.push_back({"control.axes", "numbers of axes are of a Fanuc and its like"});
  }
  if (setup.rapids) {
    const int is_straight = *setup.rapids == machine::RapidPath::Straight ? 1 : 0;
    assignments.emplace_back(fmt::format("$MC_G0_LINEAR_MODE={}", is_straight), "control.rapids");
  }
  for (const auto& [name, datum] : setup.data) {
    for (std::string& assignment : assignments_of(name, datum)) {
      assignments.emplace_back(std::move(assignment), "data." + name);
    }
  }
  for (const auto& [assignment, key] : assignments) {
    if (const auto wrong = runner.run_text(assignment)) {
      refused.push_back({key, fmt::format("{}: {}", assignment, *wrong)});
    }
  }
}

/// Whether a sheet gives a machine datum.
bool is_said(const runtime::ControlSetup& setup, std::string_view name) {
  return std::ranges::any_of(setup.data,
                             [&](const auto& datum) { return datum.first.starts_with(name); });
}

/// On a lathe T brings the tool as its turret does, unless data say otherwise.
void preset_tool_change(Runner& runner, const runtime::ControlSetup& setup) {
  static constexpr std::string_view kName = "$MC_TOOL_CHANGE_MODE";
  if (runner.channel().is_lathe() && !is_said(setup, kName)) {
    G31_EXPECTS(!runner.run_text(fmt::format("{}=0", kName)));
  }
}

/// On a lathe the rotary axis that turns the part about Z is its first spindle, unless data say
/// which axis is one.
void preset_spindle_axis(Runner& runner, const runtime::ControlSetup& setup) {
  static constexpr std::string_view kName = "$MA_SPIND_ASSIGN_TO_MACHAX";
  if (!runner.channel().is_lathe() || is_said(setup, kName)) {
    return;
  }
  for (const char letter : setup.kinematics.table_side) {
    const int axis = axis_named(std::string_view(&letter, 1));
    if (is_rotary_axis(axis) && !runner.channel().axis_of_spindle(1) &&
        setup.kinematics.rotary.at(static_cast<std::size_t>(axis) - kLinearAxisCount)
            .axis_M.normalized()
            .isApprox(Point::UnitZ())) {
      G31_EXPECTS(!runner.run_text(fmt::format("{}[{}]=1", kName, letter)));
    }
  }
}

/// A sheet that gives any settable frame means the others to be absent.
std::set<int> left_out_of(const std::map<std::string, AxisPositions>& offsets) {
  std::set<int> given;
  for (const auto& [name, q_offset] : offsets) {
    if (const auto number = settable_in_name(name)) {
      given.insert(*number);
    }
  }
  std::set<int> rest;
  for (int number = 1; !given.empty() && number < Channel::kSettableFrames; ++number) {
    if (!given.contains(number)) {
      rest.insert(number);
    }
  }
  return rest;
}

void configure_tables(Channel& channel, const runtime::ControlSetup& setup,
                      std::vector<runtime::RefusedSetting>& refused) {
  for (const auto& [name, q_offset] : setup.work_offsets) {
    if (name == "EXT") {
      channel.stored_frames.channel[0] = shifted(q_offset);
    } else if (const auto number = settable_in_name(name)) {
      channel.settable[static_cast<std::size_t>(*number)] = shifted(q_offset);
    } else {
      refused.push_back(
          {"work_offsets." + name,
           fmt::format("work offset {}: this control has EXT, G54 to G57, G505 to G599", name)});
    }
  }
  channel.left_out = left_out_of(setup.work_offsets);
  for (const auto& [name, shape] : setup.offset_shapes) {
    const auto number = settable_in_name(name);
    if (number || name == "EXT") {
      take_shape(number ? channel.settable[static_cast<std::size_t>(*number)]
                        : channel.stored_frames.channel[0],
                 shape);
    }
  }
  for (const auto& [number, entry] : setup.tools) {
    Tool& tool = channel.tools[number];
    tool.name = entry.name;
    tool.edges[1] = edge_from(entry);
    channel.knows_tools = true;
  }
  channel.take_stored_frames();
}

using Table = std::map<std::string, runtime::TableValue>;

/// The components of a frame that are not those of a new one.
/// @param name  as far as the axis: "$P_UIFR[1,", "$P_SETFR["
void add_changes(const std::string& name, const Frame& frame, Table& table) {
  const Frame fresh;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
      const auto component = static_cast<Component>(i);
      const double value = frame.component(axis, component);
      if (value != fresh.component(axis, component)) {
        table.emplace(fmt::format("{}{},{}]", name, kAxisLetters[static_cast<std::size_t>(axis)],
                                  kComponentNames.at(i)),
                      runtime::TableValue{value, fresh.component(axis, component)});
      }
    }
  }
}

/// Basic and system frames as the control keeps them.
void add_stored_frames(const FrameSet& stored, Table& table) {
  for (std::size_t i = 0; i < FrameSet::kBases; ++i) {
    add_changes(fmt::format("$P_NCBFR[{},", i), stored.global.at(i), table);
    add_changes(fmt::format("$P_CHBFR[{},", i), stored.channel.at(i), table);
  }
  add_changes("$P_PARTFR[", stored.part, table);
  add_changes("$P_SETFR[", stored.set, table);
  add_changes("$P_EXTFR[", stored.external, table);
  add_changes("$P_TOOLFR[", stored.tool, table);
  add_changes("$P_WPFR[", stored.workpiece, table);
  add_changes("$P_TRAFR[", stored.transformation, table);
  add_changes("$P_CYCFR[", stored.cycle, table);
}

}  // namespace

Session::Session(ProgramLibrary& library, machine::MachinePort& port, runtime::Observer& observer)
    : programs_(library) {
  const auto& definitions = library.definitions();
  runner_ = std::make_unique<Runner>(programs_, port, observer);
  for (const CompiledProgram* const program : definitions) {
    runner_->run_before(*program);
  }
  runner_->channel().loads_data = true;
  for (const CompiledProgram* const program : library.initial_data()) {
    runner_->run_before(*program);
  }
  runner_->channel().loads_data = false;
  numbers_at_start_ = runner_->channel().numbers;
  texts_at_start_ = runner_->channel().texts;
}

Session::~Session() = default;

std::vector<runtime::RefusedSetting> Session::configure(const runtime::ControlSetup& setup) {
  std::vector<runtime::RefusedSetting> refused;
  Channel& channel = runner_->channel();
  channel.block_skip = setup.block_skip;
  channel.feed_switches = setup.feed_switches;
  channel.inputs = runtime::InputScripts(setup.inputs);
  channel.points.q_M_reference = setup.q_M_reference;
  channel.tool_spindle = setup.tool_spindle;
  for (const auto& [letter, axis] : setup.further_axes) {
    channel.further_axes[axis_named(std::string_view(&letter, 1))] = {
        axis.home, axis.home, axis.rapid_per_min, axis.travel_min, axis.travel_max};
  }
  configure_tables(channel, setup, refused);
  for (const auto& [number, value] : setup.parameters) {
    refused.push_back({"parameters." + number,
                       "[parameters] are for other controls: set $MN_, $MC_, $SNS_ and the like in "
                       "[machine_data]"});
  }
  for (const auto& [code, program] : setup.macro_calls) {
    refused.push_back({"macro_calls." + code, "[macro_calls] are for other controls"});
  }
  configure_carrier(channel, setup);
  configure_data(*runner_, setup, refused);
  preset_tool_change(*runner_, setup);
  preset_spindle_axis(*runner_, setup);
  channel.preset_rapids();
  channel.preset_codes();
  channel.compensation_data.activate(channel);
  numbers_at_start_ = channel.numbers;
  texts_at_start_ = channel.texts;
  for (const auto& [name, value] : setup.variables) {
    auto wrong = name.starts_with('#')
                     ? std::optional<std::string>("not a variable of this control")
                     : runner_->why_no_variable(name);
    if (!wrong) {
      wrong = runner_->run_text(fmt::format("{}={}", name, written_number(value.value_or(0.0))));
    }
    if (wrong) {
      refused.push_back({"variables." + name, fmt::format("variable {}: {}", name, *wrong)});
    }
  }
  return refused;
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
  return std::make_unique<runtime::KeptState<ChannelState>>(runner_->channel());
}

std::vector<runtime::CallLevel> Session::call_levels() const {
  return runner_->call_levels();
}

runtime::NamedValues Session::values(std::size_t level, runtime::Scope scope) {
  runtime::NamedValues values;
  if (scope == runtime::Scope::Local) {
    for (const auto& [name, value] : runner_->local_values(level)) {
      values.emplace_back(name, shown_value(value));
    }
    return values;
  }
  for (const auto& [name, number] : permanent_variables()) {
    values.emplace_back(name, runtime::Cell(number));
  }
  for (const ChangedElement& element : changed_elements()) {
    if (element.type == Type::String) {
      values.emplace_back(element.name, runner_->channel().texts[element.place]);
    }
  }
  return values;
}

runtime::NamedValues Session::values_at_start() const {
  runtime::NamedValues values;
  for (const ChangedElement& element : changed_elements()) {
    values.emplace_back(element.name, element.type == Type::String
                                          ? runtime::ShownValue(texts_at_start_[element.place])
                                          : runtime::Cell(numbers_at_start_[element.place]));
  }
  return values;
}

Result<runtime::ShownValue, std::string> Session::evaluate(std::size_t level,
                                                           const std::string& text) {
  const auto value = runner_->evaluate(level, text);
  return value ? Result<runtime::ShownValue, std::string>(shown_value(value.value()))
               : value.error();
}

std::optional<std::string> Session::wrong_expression(const std::string& text) {
  const auto wrong = runner_->wrong_expression(text);
  return wrong ? std::optional(fmt::format("{}: {}", text, *wrong)) : std::nullopt;
}

Result<runtime::ShownValue, std::string> Session::variable(const std::string& name) {
  const auto value = runner_->value_of(name);
  if (!value) {
    return fmt::format("{}: {}", name, value.error());
  }
  return shown_value(value.value());
}

std::optional<double> Session::work_offset(const std::string& name, int axis) const {
  const Channel& channel = runner_->channel();
  const auto number = settable_in_name(name);
  if (!number && name != "EXT") {
    return std::nullopt;
  }
  const Frame& frame = number ? channel.settable.at(static_cast<std::size_t>(*number))
                              : channel.stored_frames.channel[0];
  return frame.component(axis, Component::Coarse) + frame.component(axis, Component::Fine);
}

std::map<std::string, runtime::TableValue> Session::tables() const {
  const Channel& channel = runner_->channel();
  Table table;
  for (std::size_t i = 0; i < channel.settable.size(); ++i) {
    add_changes(fmt::format("$P_UIFR[{},", i), channel.settable[i], table);
  }
  add_stored_frames(channel.stored_frames, table);
  for (const auto& [number, tool] : channel.tools) {
    for (const auto& [edge, data] : tool.edges) {
      for (std::size_t datum = 1; datum < data.size(); ++datum) {
        if (data.at(datum) != 0.0) {
          table.emplace(fmt::format("$TC_DP{}[{},{}]", datum, number, edge),
                        runtime::TableValue{data.at(datum)});
        }
      }
    }
  }
  return table;
}

/// Of the variables of all programs, numbers and texts that are not as at the start.
std::vector<Session::ChangedElement> Session::changed_elements() const {
  const Channel& channel = runner_->channel();
  std::vector<ChangedElement> changed;
  for (const Variable& variable : programs_.globals().variables()) {
    for (std::int32_t i = 0; i < variable.shape.count(); ++i) {
      const auto place = static_cast<std::size_t>(variable.place + i);
      const bool differs =
          variable.type == Type::String
              ? channel.texts[place] != texts_at_start_[place]
              : is_number(variable.type) && channel.numbers[place] != numbers_at_start_[place];
      if (differs) {
        changed.push_back({element_name(variable, i), variable.type, place});
      }
    }
  }
  return changed;
}

std::map<std::string, double> Session::permanent_variables() const {
  std::map<std::string, double> kept;
  for (const ChangedElement& element : changed_elements()) {
    if (element.type != Type::String) {
      kept[element.name] = runner_->channel().numbers[element.place];
    }
  }
  return kept;
}

void Session::give_files(const std::map<std::string, std::string>& files) {
  runner_->channel().files = ProgramFiles(files);
}

const std::map<std::string, std::string>& Session::files() const {
  return runner_->channel().files.all();
}

}  // namespace g31::sinumerik

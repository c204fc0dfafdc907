#include "interpreter/dialects/sinumerik/run/session.h"

#include <charconv>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/runner.h"

namespace g31::sinumerik {
namespace {

/// "G54" is settable frame 1, "G505" 5, "G500" 0.
std::optional<int> settable_in_name(const std::string& name) {
  const auto code = find_g_code(name);
  if (!code || g_codes()[code->row].group != 8) {
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

/// A line of the tool table as edge D1: 3 length, 6 radius, 12 and 15 their wear.
EdgeData edge_from(const runtime::ToolEntry& entry) {
  EdgeData edge = {};
  edge[1] = entry.type;
  edge[3] = entry.length_mm;
  edge[6] = entry.radius_mm;
  edge[12] = entry.length_wear_mm;
  edge[15] = entry.radius_wear_mm;
  return edge;
}

/// With every digit; the exponent as the language writes it.
std::string assignment(const std::string& name, double value) {
  std::string number = fmt::format("{}", value);
  if (const std::size_t exponent = number.find('e'); exponent != std::string::npos) {
    number.replace(exponent, 1, "EX");
  }
  return fmt::format("{}={}", name, number);
}

/// "R5", "_OVR[0]", "$MA_MAX_AX_ACCEL[X]", "TABLE[1,2]"
std::string name_of_element(const Variable& variable, std::int32_t element) {
  if (variable.name == "R") {
    return fmt::format("R{}", element);
  }
  if (variable.shape.dimensions == 0) {
    return variable.name;
  }
  const bool by_axis = variable.name.starts_with("$MA_");
  std::string indices;
  for (int i = variable.shape.dimensions - 1; i >= 0; --i) {
    const int size = variable.shape.size[static_cast<std::size_t>(i)];
    const int index = element % size;
    const bool is_axis = by_axis && i == variable.shape.dimensions - 1;
    const std::string shown_index =
        is_axis ? std::string(1, kAxisLetters[static_cast<std::size_t>(index)])
                : std::to_string(index);
    indices = shown_index + (indices.empty() ? "" : ",") + indices;
    element /= size;
  }
  return fmt::format("{}[{}]", variable.name, indices);
}

void configure_tables(Channel& channel, const runtime::ControlSetup& setup,
                      std::vector<std::string>& refused) {
  for (const auto& [name, q_offset] : setup.work_offsets) {
    if (name == "EXT") {
      channel.stored_base = shifted(q_offset);
    } else if (const auto number = settable_in_name(name)) {
      channel.settable[static_cast<std::size_t>(*number)] = shifted(q_offset);
    } else {
      refused.push_back(
          fmt::format("work offset {}: this control has EXT, G54 to G57, G505 to G599", name));
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
}

Session::~Session() = default;

std::vector<std::string> Session::configure(const runtime::ControlSetup& setup) {
  std::vector<std::string> refused;
  Channel& channel = runner_->channel();
  channel.block_skip = setup.block_skip;
  channel.feed_switches = setup.feed_switches;
  channel.points.q_M_reference = setup.q_M_reference;
  configure_tables(channel, setup, refused);
  if (!setup.parameters.empty() || !setup.macro_calls.empty()) {
    refused.emplace_back(
        "[parameters] and [macro_calls] are of other controls: set $MN_, $MC_, $SNS_ and the like "
        "in "
        "[variables]");
  }
  for (const auto& [name, value] : setup.variables) {
    const bool is_fanuc_input = name.starts_with('#');
    const auto wrong = is_fanuc_input ? std::optional<std::string>("no variable of this control")
                                      : runner_->run_text(assignment(name, value.value_or(0.0)));
    if (wrong) {
      refused.push_back(fmt::format("variable {}: {}", name, *wrong));
    }
  }
  return refused;
}

runtime::Outcome Session::run(const runtime::Budget& budget) {
  return runner_->run(budget);
}

Result<runtime::ShownValue, std::string> Session::variable(const std::string& name) {
  const auto value = runner_->value_of(name);
  if (!value) {
    return fmt::format("{}: {}", name, value.error());
  }
  if (value.value().type == Type::String) {
    return runtime::ShownValue(value.value().text);
  }
  if (value.value().type == Type::Axis) {
    return runtime::ShownValue(shown(Type::Axis, value.value().number));
  }
  return runtime::ShownValue(runtime::Cell(value.value().number));
}

std::map<std::string, double> Session::permanent_variables() const {
  std::map<std::string, double> kept;
  const std::vector<double>& numbers = runner_->channel().numbers;
  for (const Variable& variable : programs_.globals().variables()) {
    if (!is_number(variable.type)) {
      continue;
    }
    for (std::int32_t i = 0; i < variable.shape.count(); ++i) {
      const auto place = static_cast<std::size_t>(variable.place + i);
      if (numbers[place] != numbers_at_start_[place]) {
        kept[name_of_element(variable, i)] = numbers[place];
      }
    }
  }
  return kept;
}

void Session::give_files(const std::map<std::string, std::string>& files) {
  runner_->channel().files = files;
}

const std::map<std::string, std::string>& Session::files() const {
  return runner_->channel().files;
}

}  // namespace g31::sinumerik

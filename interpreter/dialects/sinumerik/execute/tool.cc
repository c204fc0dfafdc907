#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/runtime/probe_inside.h"

namespace g31::sinumerik {
namespace {

constexpr double kToolChange = 6.0;  // M6
constexpr int kPerRevolution = number_in_group("G95");
constexpr int kPerAdditive = 10;     // numbers of $TC_SCP for one DL,
constexpr int kFirstOfAdditive = 3;  // behind the tenfold of which its parameters begin

/// The number of the tool that T names; 0 for none.
Result<int, Failure> named_tool(const Channel& channel, const BlockWords& words) {
  if (!words.tool_name) {
    const double number = words[Address::Tool].value;
    auto wrong = wrong_tool(number);
    return wrong ? Result<int, Failure>(failure(*std::move(wrong))) : static_cast<int>(number);
  }
  if (words.tool_name->empty()) {
    return 0;
  }
  for (const auto& [number, tool] : channel.tools) {
    if (tool.name == *words.tool_name) {
      return number;
    }
  }
  return missing_tool(*words.tool_name);
}

/// A set-up sheet without tools leaves them all to the program: length and radius 0.
MaybeFailure know(Channel& channel, int number) {
  if (number == 0 || channel.find_tool(number) != nullptr) {
    return std::nullopt;
  }
  if (channel.knows_tools) {
    return message_failure(runtime::Status::Setup, source::DiagnosticId::SetupMissingTool,
                           fmt::format("T{}", number));
  }
  channel.tools[number].edges[1] = EdgeData();
  return std::nullopt;
}

MaybeFailure select_edge(Channel& channel, double number) {
  if (MaybeFailure wrong = failure(wrong_edge(number))) {
    return wrong;
  }
  const int edge = static_cast<int>(number);
  const EdgeData* const data = edge != 0 ? channel.find_edge(channel.tool, edge) : nullptr;
  if (edge != 0 && channel.tool != 0 && data == nullptr) {
    return failure(AlarmId::NoToolEdge, fmt::format("T{}, D{}", channel.tool, edge));
  }
  channel.edge = edge;
  channel.edge_now = data != nullptr ? std::optional(*data) : std::nullopt;
  channel.additive = 0;
  channel.additive_now = {};
  channel.frames_changed();
  return std::nullopt;
}

/// What DL adds to parameters 3 to 6 of an edge.
std::array<double, 4> additive_of(const Tool& tool, int edge, int additive) {
  std::array<double, 4> sums = {};
  for (int i = 0; i < 4 && additive > 0; ++i) {
    const int number = kPerAdditive * additive + kFirstOfAdditive + i;
    sums[static_cast<std::size_t>(i)] = tool.datum({SystemId::AdditiveParameter, edge, number}) +
                                        tool.datum({SystemId::SetupParameter, edge, number});
  }
  return sums;
}

/// DL: what $TC_SCP or $TC_ECP has made of the edge in force.
MaybeFailure select_additive(Channel& channel, double number) {
  if (MaybeFailure wrong = failure(wrong_additive(number))) {
    return wrong;
  }
  const Tool* const tool = channel.find_tool(channel.tool);
  const auto is_of_it = [&](const auto& row) {
    return row.first.edge == channel.edge &&
           (row.first.number - kFirstOfAdditive) / kPerAdditive == static_cast<int>(number) &&
           (row.first.id == SystemId::AdditiveParameter ||
            row.first.id == SystemId::SetupParameter);
  };
  const bool is_there = number == 0.0 || (tool != nullptr && channel.edge != 0 &&
                                          std::ranges::any_of(tool->more, is_of_it));
  if (!is_there) {
    return failure(AlarmId::NoAdditiveOffset,
                   fmt::format("T{}, D{}, DL={:g}", channel.tool, channel.edge, number));
  }
  channel.additive = static_cast<int>(number);
  channel.additive_now = tool != nullptr ? additive_of(*tool, channel.edge, channel.additive)
                                         : std::array<double, 4>();
  channel.frames_changed();
  return std::nullopt;
}

/// FZ
MaybeFailure take_tooth_feed(Channel& channel, double per_tooth) {
  if (channel.group[Group::FeedType] != kPerRevolution) {
    return failure(AlarmId::WrongFeedType, fmt::format("FZ={:g}", per_tooth));
  }
  const Tool* const tool = channel.find_tool(channel.tool);
  const double count =
      tool != nullptr && tool->teeth.contains(channel.edge) ? tool->teeth.at(channel.edge) : 0.0;
  if (!(per_tooth * count > 0.0)) {
    return failure(AlarmId::FeedNotPositive, fmt::format("FZ={:g}, {:g} teeth", per_tooth, count));
  }
  channel.feed = programmed(channel, per_tooth * count);
  return std::nullopt;
}

/// SVC, m/min
MaybeFailure take_cutting_speed(Channel& channel, double speed) {
  const double radius = channel.tool_radius();
  if (!(radius > 0.0) || !(speed > 0.0)) {
    return failure(AlarmId::NoToolForSpeed,
                   fmt::format("SVC={:g}, tool radius {:g}", speed, radius));
  }
  channel.spindle.speed = speed * kMmPerMetre / (2.0 * std::numbers::pi * radius);
  tell_spindle(channel);
  return std::nullopt;
}

double along(const ToolLengths& lengths, char axis) {
  double sum = 0.0;
  for (std::size_t i = 0; i < lengths.axes.size(); ++i) {
    sum += lengths.axes.at(i) == axis_index(axis) ? lengths.mm.at(i) : 0.0;
  }
  return sum;
}

/// The active tool as its data have it.
machine::Tool believed_tool(const Channel& channel) {
  machine::Tool tool{channel.tool, 0.0, channel.tool_radius()};
  const EdgeData* const data = channel.active_edge();
  if (data == nullptr) {
    return tool;
  }
  const ToolLengths lengths = channel.tool_lengths();
  if (!is_turning_type((*data)[EdgeDatum::kType])) {
    // Length 1 of a mill is along its axis, whichever plane is active.
    tool.length_mm = lengths.as_turning_tool ? along(lengths, 'Z') : lengths.mm.front();
    return tool;
  }
  const double position = (*data)[EdgeDatum::kPosition];
  machine::Tool::Edge edge;
  edge.lengths_mm = {along(lengths, 'X'), along(lengths, 'Z'), along(lengths, 'Y')};
  if (position >= 1.0 && position < edge.position) {
    edge.position = static_cast<int>(position);
  }
  tool.length_mm = edge.lengths_mm[1];
  tool.edge = edge;
  return tool;
}

}  // namespace

MaybeFailure take_tool_technology(Channel& channel, const Block& block) {
  const BlockWords& words = block.words;
  MaybeFailure wrong = words.has(Address::CuttingSpeed)
                           ? take_cutting_speed(channel, words[Address::CuttingSpeed].value)
                           : std::nullopt;
  if (!wrong && words.has(Address::ToothFeed)) {
    wrong = take_tooth_feed(channel, words[Address::ToothFeed].value);
  }
  return wrong;
}

void tell_idle_edge(Channel& channel) {
  if (channel.idle_edge) {
    channel.warnings.add(
        channel.diagnostics, source::DiagnosticId::WordWithoutEffect, channel.idle_edge->where,
        fmt::format("D{}, for T waits for M6 and no tool is there", channel.idle_edge->number));
    channel.idle_edge.reset();
  }
}

/// D of a block waits for its tool with T; D0, T0 and another T end that.
void note_idle_edge(Channel& channel, const Block& block) {
  const bool waits = channel.tool == 0 && channel.selected_tool.value_or(0) != 0;
  channel.idle_edge.reset();
  if (waits && channel.edge != 0 && block.words.has(Address::Edge)) {
    channel.idle_edge = {channel.edge, block.where};
  }
}

MaybeFailure select_tool(Channel& channel, const Block& block) {
  const BlockWords& words = block.words;
  if (words.has(Address::Tool)) {
    const auto number = named_tool(channel, words);
    if (!number) {
      return number.error();
    }
    if (MaybeFailure wrong = know(channel, number.value())) {
      return wrong;
    }
    channel.selected_tool = number.value();
  }
  bool changes = words.has(Address::Tool) && channel.changes_with_t();
  for (std::size_t i = 0; i < words.machine_code_count; ++i) {
    changes = changes || words.machine_codes[i] == kToolChange;
  }
  if (changes) {
    channel.tool = channel.selected_tool.value_or(0);
    if (channel.idle_edge && channel.idle_edge->number != 1) {
      tell_idle_edge(channel);
    }
    channel.idle_edge.reset();
    // A new tool comes with its first edge.
    if (MaybeFailure wrong = select_edge(channel, channel.tool == 0 ? 0.0 : 1.0)) {
      return wrong;
    }
    const machine::Tool believed = believed_tool(channel);
    const std::array<double, 3> lengths = channel.tool_lengths().mm;
    if (!std::ranges::all_of(lengths, [](double mm) { return std::isfinite(mm); })) {
      return failure(AlarmId::ValueOutOfLimits, fmt::format("the length of T{}", channel.tool));
    }
    if (!channel.selected_tool) {
      channel.warnings.add(channel.diagnostics, source::DiagnosticId::ChangeWithoutTool,
                           block.where);
    } else {
      channel.port.change_tool({believed});
      if (const auto inside = runtime::comes_inside(channel.port)) {
        channel.warnings.add(channel.diagnostics, source::DiagnosticId::StartInside, block.where,
                             *inside);
      }
    }
  }
  MaybeFailure wrong =
      words.has(Address::Edge) ? select_edge(channel, words[Address::Edge].value) : std::nullopt;
  if (!wrong && (words.has(Address::Edge) || words.has(Address::Tool))) {
    note_idle_edge(channel, block);
  }
  if (!wrong && words.has(Address::Additive)) {
    wrong = select_additive(channel, words[Address::Additive].value);
  }
  return wrong;
}

}  // namespace g31::sinumerik

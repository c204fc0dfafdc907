#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {
namespace {

constexpr double kToolChange = 6.0;  // M6

/// The number of the tool that T names; 0 for none.
Result<int, Failure> named_tool(const Channel& channel, const BlockWords& words) {
  if (!words.tool_name) {
    const double number = words[Address::Tool].value;
    if (number < 0.0 || number != std::floor(number) || number > 1e8) {
      return failure(AlarmId::BadTNumber, fmt::format("T{}", number));
    }
    return static_cast<int>(number);
  }
  if (words.tool_name->empty()) {
    return 0;
  }
  for (const auto& [number, tool] : channel.tools) {
    if (tool.name == *words.tool_name) {
      return number;
    }
  }
  return failure(AlarmId::BadToolName, *words.tool_name);
}

/// A set-up sheet without tools leaves them all to the program: length and radius 0.
MaybeFailure know(Channel& channel, int number) {
  if (number == 0 || channel.find_tool(number) != nullptr) {
    return std::nullopt;
  }
  if (channel.knows_tools) {
    Failure missing = failure(AlarmId::BadTNumber, fmt::format("T{}", number));
    missing.status = runtime::Status::Setup;
    missing.number = static_cast<int>(source::DiagnosticId::SetupMissingTool);
    return missing;
  }
  channel.tools[number].edges[1] = EdgeData();
  return std::nullopt;
}

MaybeFailure select_edge(Channel& channel, double number) {
  if (number < 0.0 || number != std::floor(number) || number > 32000.0) {
    return failure(AlarmId::BadDNumber, fmt::format("D{}", number));
  }
  const int edge = static_cast<int>(number);
  const EdgeData* const data = edge != 0 ? channel.find_edge(channel.tool, edge) : nullptr;
  if (edge != 0 && channel.tool != 0 && data == nullptr) {
    return failure(AlarmId::NoToolEdge, fmt::format("T{}, D{}", channel.tool, edge));
  }
  channel.edge = edge;
  channel.edge_now = data != nullptr ? std::optional(*data) : std::nullopt;
  channel.frames_changed();
  return std::nullopt;
}

}  // namespace

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
  bool changes = false;
  for (std::size_t i = 0; i < words.machine_code_count; ++i) {
    changes = changes || words.machine_codes[i] == kToolChange;
  }
  if (changes) {
    channel.tool = channel.selected_tool;
    // A new tool comes with its first edge.
    if (MaybeFailure wrong = select_edge(channel, channel.tool == 0 ? 0.0 : 1.0)) {
      return wrong;
    }
  }
  return words.has(Address::Edge) ? select_edge(channel, words[Address::Edge].value) : std::nullopt;
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/functions.h"
#include "interpreter/dialects/sinumerik/run/procedures.h"

namespace g31::sinumerik {
namespace {

constexpr int kActive = 1;        // bit of $TC_TP8
constexpr double kNoTool = -1.0;  // of GETT
constexpr double kNoName = -1.0;  // of GETACTT
constexpr double kNotInUse = -2.0;
constexpr double kMostDuplo = 32000.0;

using Row = std::pair<const int, Tool>;

double number_of_tool(const std::map<int, Tool>& tools, const std::string& name, double duplo) {
  const auto found = std::ranges::find_if(
      tools, [&](const Row& row) { return row.second.name == name && row.second.duplo == duplo; });
  return found != tools.end() ? found->first : kNoTool;
}

/// A number of a tool or edge, as a function is given it; 0, which none has, where it is too large.
int numbered(double given) {
  constexpr double kMost = 2147483647.0;
  return given >= 1.0 && given <= kMost ? static_cast<int>(given) : 0;
}

/// The highest duplo number of a name; 0: there is none of it.
double last_duplo(const std::map<int, Tool>& tools, const std::string& name) {
  double last = 0.0;
  for (const auto& [number, tool] : tools) {
    last = tool.name == name ? std::max(last, tool.duplo) : last;
  }
  return last;
}

/// The tool of a name with the lowest duplo number; 0: there is none.
int first_of_name(const std::map<int, Tool>& tools, const std::string& name) {
  int first = 0;
  for (const auto& [number, tool] : tools) {
    if (tool.name == name && (first == 0 || tool.duplo < tools.at(first).duplo)) {
      first = number;
    }
  }
  return first;
}

/// The tool of a name that is in use: its number, or why there is none.
double tool_in_use(const Channel& channel, const std::string& name) {
  for (const int number : {channel.tool, channel.selected_tool.value_or(0)}) {
    const auto found = channel.tools.find(number);
    if (found != channel.tools.end() && found->second.name == name) {
      return number;
    }
  }
  double result = kNoName;
  for (const auto& [number, tool] : channel.tools) {
    if (tool.name == name) {
      if ((static_cast<int>(tool.state) & kActive) != 0) {
        return number;
      }
      result = kNotInUse;
    }
  }
  return result;
}

/// The tool of a name and, if it is there, a duplo number; 0 or less: there is none.
double tool_named(const Channel& channel, Operands& at, Arguments list) {
  const std::string& name = at.text(list[0].value);
  return list.size() > 1 ? number_of_tool(channel.tools, name, rounded(at.number(list[1])))
                         : first_of_name(channel.tools, name);
}

}  // namespace

namespace function {

/// GETDNO(tool, edge)
MaybeFailure number_of_edge(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const double given = rounded(at.number(list[0]));
  const int tool = numbered(given);
  if (channel.find_tool(tool) == nullptr) {
    return failure(AlarmId::BadTNumber, fmt::format("T{:.0f}", given));
  }
  const int edge = numbered(rounded(at.number(list[1])));
  at.number(op.result) = channel.find_edge(tool, edge) != nullptr ? edge : 0.0;
  return std::nullopt;
}

/// CHKDNO(t1, t2, d): of two tools or of all, of one D number or of all.
MaybeFailure edges_are_unique(Channel& channel, Operands& at, const Op& op, Arguments list) {
  std::array<double, 3> given = {};
  for (std::size_t i = 0; i < list.size(); ++i) {
    given.at(i) = rounded(at.number(list[i]));
    if (i < 2 && channel.find_tool(numbered(given.at(i))) == nullptr) {
      return failure(AlarmId::BadTNumber, fmt::format("T{:.0f}", given.at(i)));
    }
  }
  std::map<int, int> tools_of_edge;
  for (const auto& [number, tool] : channel.tools) {
    const bool is_asked = list.size() < 2 ? list.empty() || number == given[0]
                                          : number == given[0] || number == given[1];
    for (const auto& [edge, data] : tool.edges) {
      tools_of_edge[edge] += is_asked && (list.size() < 3 || edge == given[2]) ? 1 : 0;
    }
  }
  at.number(op.result) =
      std::ranges::all_of(tools_of_edge, [](const auto& row) { return row.second <= 1; }) ? 1.0
                                                                                          : 0.0;
  return std::nullopt;
}

/// AXTOSPI(axis)
MaybeFailure spindle_of_axis(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const auto axis = static_cast<int>(at.number(list[0]));
  for (int spindle = 1; spindle <= kMostSpindles; ++spindle) {
    if (channel.axis_of_spindle(spindle) == axis) {
      at.number(op.result) = spindle;
      return std::nullopt;
    }
  }
  return failure(AlarmId::BadAxisIndex, "AXTOSPI: no axis that a spindle is, MD35000");
}

/// SPI(spindle)
MaybeFailure axis_of_spindle(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const double spindle = rounded(at.number(list[0]));
  const bool can_be = spindle >= 1.0 && spindle <= kMostSpindles;
  const auto axis =
      can_be ? channel.axis_of_spindle(static_cast<int>(spindle)) : std::optional<int>();
  if (!axis) {
    return failure(AlarmId::BadAxisIndex, "SPI: no axis is this spindle, MD35000");
  }
  at.number(op.result) = *axis;
  return std::nullopt;
}

/// GETACTT(variable, name)
MaybeFailure named_tool_in_use(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const double found = tool_in_use(channel, at.text(list[1].value));
  at.number(op.result) = std::min(found, 0.0);
  return found > 0.0 ? at.assign(list[0], found) : std::nullopt;
}

/// GETT(name, duplo)
MaybeFailure named_tool(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const double duplo = list.size() > 1 ? rounded(at.number(list[1])) : 1.0;
  at.number(op.result) = number_of_tool(channel.tools, at.text(list[0].value), duplo);
  return std::nullopt;
}

/// NEWT(name, duplo)
MaybeFailure new_tool(Channel& channel, Operands& at, const Op& op, Arguments list) {
  const std::string name = at.text(list[0].value);
  const double duplo =
      list.size() > 1 ? rounded(at.number(list[1])) : last_duplo(channel.tools, name) + 1.0;
  const bool is_valid = !name.empty() && duplo >= 1.0 && duplo <= kMostDuplo;
  if (!is_valid || number_of_tool(channel.tools, name, duplo) != kNoTool) {
    return failure(AlarmId::ToolExists, fmt::format("\"{}\", {:g}", name, duplo));
  }
  int free = 1;
  while (channel.tools.contains(free)) {
    ++free;
  }
  Tool& tool = channel.tools[free];
  tool.name = name;
  tool.duplo = duplo;
  tool.edges[1] = EdgeData();
  at.number(op.result) = free;
  return std::nullopt;
}

}  // namespace function

namespace procedure {

/// GETSELT(variable, spindle)
double selected_tool(Channel& channel, Operands& /*at*/, Arguments /*list*/) {
  return channel.selected_tool.value_or(0);
}

/// GETEXET(variable, spindle)
double tool_in_spindle(Channel& channel, Operands& /*at*/, Arguments /*list*/) {
  return channel.tool;
}

/// TCA(name, duplo, holder)
MaybeFailure select_named_tool(Channel& channel, Operands& at, Arguments list) {
  const double found = tool_named(channel, at, list);
  if (found <= 0.0) {
    return missing_tool(at.text(list[0].value));
  }
  channel.selected_tool = static_cast<int>(found);
  return std::nullopt;
}

/// DELT(name, duplo)
MaybeFailure delete_tool(Channel& channel, Operands& at, Arguments list) {
  const double found = tool_named(channel, at, list);
  if (found <= 0.0) {
    return failure(AlarmId::BadToolName, at.text(list[0].value));
  }
  const auto which = static_cast<int>(found);
  if (which == channel.tool || which == channel.selected_tool) {
    return failure(AlarmId::ToolInUse, fmt::format("T{}", which));
  }
  channel.tools.erase(which);
  return std::nullopt;
}

}  // namespace procedure
}  // namespace g31::sinumerik

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

Failure no_edge(int tool, int edge) {
  return failure(AlarmId::NoToolEdge, fmt::format("T{}, D{}", tool, edge));
}

Failure no_edge(const SystemAccess& access) {
  return no_edge(access.indices[0], access.indices[1]);
}

Failure no_tool(int tool) {
  return failure(AlarmId::BadTNumber, fmt::format("T{}", tool));
}

/// $P_AD[n]: there are the parameters 1 to 25.
MaybeFailure no_parameter(int which) {
  return which >= 1 && which < static_cast<int>(EdgeData().size())
             ? std::nullopt
             : MaybeFailure(failure(AlarmId::IndexOne, fmt::format("$P_AD[{}]", which)));
}

/// The number of the i-th row of a map, i from 1; 0: it has not so many.
template <typename Map>
double number_at(const Map& rows, int which) {
  const bool is_there = which >= 1 && which <= static_cast<int>(rows.size());
  return is_there ? static_cast<double>(std::next(rows.begin(), which - 1)->first) : 0.0;
}

Tool::Datum datum_of(const SystemAccess& access, int edge) {
  return {access.id, edge, access.parameter};
}

using FoundTool = Result<Tool*, Failure>;

/// The tool of the first index.
FoundTool tool_of(Channel& channel, const SystemAccess& access) {
  Tool* const tool = channel.find_tool(access.indices[0]);
  return tool != nullptr ? FoundTool(tool) : no_tool(access.indices[0]);
}

FoundTool tool_to_write(Channel& channel, const SystemAccess& access) {
  Tool* const tool = channel.tool_to_write(access.indices[0]);
  return tool != nullptr ? FoundTool(tool) : no_tool(access.indices[0]);
}

/// A tool that has the edge of the second index.
FoundTool with_edge(FoundTool tool, const SystemAccess& access) {
  return tool && !tool.value()->edges.contains(access.indices[1]) ? no_edge(access) : tool;
}

/// mm for one unit of a parameter of $TC_DP: lengths, radii and their wear are 3 to 23 but for
/// angles; 1 for all others.  Source: Tool Management, cutting edge parameters DP1 to DP25.
double unit_of_edge(const Channel& channel, int parameter) {
  constexpr int kFirstLength = 3;
  constexpr int kLastLength = 23;
  constexpr int kAngles[] = {10, 11, 19, 20};
  const bool is_length = parameter >= kFirstLength && parameter <= kLastLength &&
                         std::ranges::find(kAngles, parameter) == std::end(kAngles);
  return is_length ? channel.mm_per_datum() : 1.0;
}

/// The same of what is kept of an edge: offsets of DL are lengths, other data as they are.
double unit_of_datum(const Channel& channel, SystemId id) {
  return id == SystemId::AdditiveParameter || id == SystemId::SetupParameter
             ? channel.mm_per_datum()
             : 1.0;
}

/// Writing to an edge that is not there makes it.
MaybeFailure write_edge(Channel& channel, const SystemAccess& access, double value) {
  if (access.indices[1] < 1) {
    return no_edge(access);
  }
  const FoundTool tool = tool_to_write(channel, access);
  if (!tool) {
    return tool.error();
  }
  tool.value()->edges[access.indices[1]][static_cast<std::size_t>(access.parameter)] =
      value * unit_of_edge(channel, access.parameter);
  return std::nullopt;
}

Number value_of(Channel& channel, const SystemAccess& access, double Tool::*datum) {
  const FoundTool tool = tool_of(channel, access);
  return tool ? Number(tool.value()->*datum) : tool.error();
}

MaybeFailure set_value(Channel& channel, const SystemAccess& access, double Tool::*datum,
                       double value) {
  const FoundTool tool = tool_to_write(channel, access);
  if (!tool) {
    return tool.error();
  }
  tool.value()->*datum = value;
  return std::nullopt;
}

}  // namespace

Number tool_radius(Channel& channel, const SystemAccess& /*access*/) {
  return channel.tool_radius() / channel.mm_per_datum();
}

Number tool_length(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (which < 1 || which > 3) {
    return failure(AlarmId::IndexOne, fmt::format("$P_TOOLL[{}]", which));
  }
  const auto index = static_cast<std::size_t>(which) - 1;
  const ToolLengths lengths = channel.tool_lengths();
  // As they act: a tool carrier turns them.
  const bool is_carried = channel.orientation.carrier != 0 && channel.active_edge() != nullptr;
  const double mm =
      is_carried ? channel.tool_offset()[lengths.axes.at(index)] : lengths.mm.at(index);
  return mm / channel.mm_per_datum();
}

Number active_edge_datum(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (MaybeFailure wrong = no_parameter(which)) {
    return *wrong;
  }
  const EdgeData* const edge = channel.active_edge();
  return edge != nullptr ? (*edge)[static_cast<std::size_t>(which)] / unit_of_edge(channel, which)
                         : 0.0;
}

MaybeFailure set_active_edge_datum(Channel& channel, const SystemAccess& access, double value) {
  const int which = access.indices[0];
  if (MaybeFailure wrong = no_parameter(which)) {
    return wrong;
  }
  if (!channel.edge_now) {
    return no_edge(channel.tool, channel.edge);
  }
  (*channel.edge_now)[static_cast<std::size_t>(which)] = value * unit_of_edge(channel, which);
  channel.frames_changed();
  SystemAccess edge = access;
  edge.parameter = which;
  edge.indices = {channel.tool, channel.edge};
  return write_edge(channel, edge, value);
}

Number tool_exists(Channel& channel, const SystemAccess& access) {
  return channel.find_tool(access.indices[0]) != nullptr ? 1.0 : 0.0;
}

Number tool_at(Channel& channel, const SystemAccess& access) {
  return number_at(channel.tools, access.indices[0]);
}

Number edge_count(Channel& channel, const SystemAccess& access) {
  const Tool* const tool = channel.find_tool(access.indices[0]);
  return tool != nullptr ? static_cast<double>(tool->edges.size()) : 0.0;
}

Number edge_at(Channel& channel, const SystemAccess& access) {
  const Tool* const tool = channel.find_tool(access.indices[0]);
  return tool != nullptr ? number_at(tool->edges, access.indices[1]) : 0.0;
}

Number edge_parameter(Channel& channel, const SystemAccess& access) {
  const EdgeData* const edge = channel.find_edge(access.indices[0], access.indices[1]);
  return edge != nullptr ? Number((*edge)[static_cast<std::size_t>(access.parameter)] /
                                  unit_of_edge(channel, access.parameter))
                         : no_edge(access);
}

MaybeFailure set_edge_parameter(Channel& channel, const SystemAccess& access, double value) {
  return write_edge(channel, access, value);
}

Number edge_teeth(Channel& channel, const SystemAccess& access) {
  const FoundTool tool = with_edge(tool_of(channel, access), access);
  if (!tool) {
    return tool.error();
  }
  const auto teeth = tool.value()->teeth.find(access.indices[1]);
  return teeth != tool.value()->teeth.end() ? teeth->second : 0.0;
}

MaybeFailure set_edge_teeth(Channel& channel, const SystemAccess& access, double value) {
  const FoundTool tool = with_edge(tool_to_write(channel, access), access);
  if (!tool) {
    return tool.error();
  }
  tool.value()->teeth[access.indices[1]] = value;
  return std::nullopt;
}

Number datum_of_edge(Channel& channel, const SystemAccess& access) {
  const FoundTool tool = with_edge(tool_of(channel, access), access);
  return tool ? Number(tool.value()->datum(datum_of(access, access.indices[1])) /
                       unit_of_datum(channel, access.id))
              : tool.error();
}

MaybeFailure set_datum_of_edge(Channel& channel, const SystemAccess& access, double value) {
  const FoundTool tool = with_edge(tool_to_write(channel, access), access);
  if (!tool) {
    return tool.error();
  }
  tool.value()->more[datum_of(access, access.indices[1])] =
      value * unit_of_datum(channel, access.id);
  return std::nullopt;
}

Number datum_of_tool(Channel& channel, const SystemAccess& access) {
  const FoundTool tool = tool_of(channel, access);
  return tool ? Number(tool.value()->datum(datum_of(access, 0))) : tool.error();
}

MaybeFailure set_datum_of_tool(Channel& channel, const SystemAccess& access, double value) {
  const FoundTool tool = tool_to_write(channel, access);
  if (!tool) {
    return tool.error();
  }
  tool.value()->more[datum_of(access, 0)] = value;
  return std::nullopt;
}

Number tool_duplo(Channel& channel, const SystemAccess& access) {
  return value_of(channel, access, &Tool::duplo);
}

MaybeFailure set_tool_duplo(Channel& channel, const SystemAccess& access, double value) {
  return set_value(channel, access, &Tool::duplo, value);
}

Number tool_state(Channel& channel, const SystemAccess& access) {
  return value_of(channel, access, &Tool::state);
}

MaybeFailure set_tool_state(Channel& channel, const SystemAccess& access, double value) {
  return set_value(channel, access, &Tool::state, value);
}

/// A tool that is not there has no name.
Text tool_name(Channel& channel, const SystemAccess& access) {
  const Tool* const tool = channel.find_tool(access.indices[0]);
  return tool != nullptr ? tool->name : std::string();
}

MaybeFailure set_tool_name(Channel& channel, const SystemAccess& access, const std::string& name) {
  const FoundTool tool = tool_to_write(channel, access);
  if (!tool) {
    return tool.error();
  }
  tool.value()->name = name;
  return std::nullopt;
}

}  // namespace g31::sinumerik::system

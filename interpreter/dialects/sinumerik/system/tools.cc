#include <iterator>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik {
namespace {

Failure no_edge(const SystemAccess& access) {
  return failure(AlarmId::NoToolEdge,
                 fmt::format("T{}, D{}", access.indices[0], access.indices[1]));
}

Failure no_tool(const SystemAccess& access) {
  return failure(AlarmId::BadTNumber, fmt::format("T{}", access.indices[0]));
}

/// Of the active edge.
Result<double, Failure> active_edge_value(const Channel& channel, const SystemAccess& access) {
  const EdgeData* const edge = channel.active_edge();
  if (access.id == SystemId::ToolRadius) {
    return channel.tool_radius();
  }
  const int which = access.indices[0];
  if (access.id == SystemId::ToolLength) {
    if (which < 1 || which > 3) {
      return failure(AlarmId::IndexOne, fmt::format("$P_TOOLL[{}]", which));
    }
    const Plane plane = channel.plane();
    const int axes[] = {plane.normal, plane.second, plane.first};
    return channel.tool_offset()[axes[which - 1]];
  }
  if (which < 1 || which >= static_cast<int>(EdgeData().size())) {
    return failure(AlarmId::IndexOne, fmt::format("$P_AD[{}]", which));
  }
  return edge != nullptr ? (*edge)[static_cast<std::size_t>(which)] : 0.0;
}

/// The number of the i-th row of a map, i from 1; 0: it has not so many.
template <typename Map>
double number_at(const Map& rows, int which) {
  const bool is_there = which >= 1 && which <= static_cast<int>(rows.size());
  return is_there ? static_cast<double>(std::next(rows.begin(), which - 1)->first) : 0.0;
}

/// $P_TOOLEXIST and the lists of tools and edges.
double list_value(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  const Tool* const tool = channel.find_tool(which);
  switch (static_cast<int>(access.id)) {
    case static_cast<int>(SystemId::ToolExists):
      return tool != nullptr ? 1.0 : 0.0;
    case static_cast<int>(SystemId::ToolMagazine):
    case static_cast<int>(SystemId::ToolPlace):
      return 0.0;
    case static_cast<int>(SystemId::ToolAt):
      return number_at(channel.tools, which);
    case static_cast<int>(SystemId::EdgeCount):
      return tool != nullptr ? static_cast<double>(tool->edges.size()) : 0.0;
    default:
      return tool != nullptr ? number_at(tool->edges, access.indices[1]) : 0.0;
  }
}

bool is_kept_of_edge(SystemId id) {
  return id >= SystemId::AdditiveParameter && id <= SystemId::EdgeLife;
}
bool needs_edge(SystemId id) {
  return is_kept_of_edge(id) || id == SystemId::EdgeTeeth;
}
bool is_kept(SystemId id) {
  return id >= SystemId::AdditiveParameter && id <= SystemId::ToolDatum;
}

Tool::Datum datum_of(const SystemAccess& access) {
  return {access.id, is_kept_of_edge(access.id) ? access.indices[1] : 0, access.parameter};
}

/// What is wrong with the tool or edge that a $TC_ variable names.
MaybeFailure missing(Channel& channel, const SystemAccess& access) {
  const Tool* const tool = channel.find_tool(access.indices[0]);
  if (tool == nullptr) {
    return no_tool(access);
  }
  return needs_edge(access.id) && !tool->edges.contains(access.indices[1])
             ? std::optional(no_edge(access))
             : std::nullopt;
}

/// $TC_..
Result<double, Failure> tool_value(Channel& channel, const SystemAccess& access) {
  if (access.id == SystemId::EdgeParameter) {
    const EdgeData* const edge = channel.find_edge(access.indices[0], access.indices[1]);
    return edge != nullptr
               ? Result<double, Failure>((*edge)[static_cast<std::size_t>(access.parameter)])
               : no_edge(access);
  }
  if (MaybeFailure wrong = missing(channel, access)) {
    return *wrong;
  }
  const Tool& tool = *channel.find_tool(access.indices[0]);
  if (access.id == SystemId::EdgeTeeth) {
    const auto teeth = tool.teeth.find(access.indices[1]);
    return teeth != tool.teeth.end() ? teeth->second : 0.0;
  }
  return is_kept(access.id)                 ? tool.datum(datum_of(access))
         : access.id == SystemId::ToolDuplo ? tool.duplo
                                            : tool.state;
}

}  // namespace

bool is_of_tools(SystemId id) {
  return (id >= SystemId::ToolRadius && id <= SystemId::ActiveEdgeData) ||
         id == SystemId::ToolExists || (id >= SystemId::ToolAt && id <= SystemId::ToolPlace) ||
         (id >= SystemId::EdgeParameter && id <= SystemId::ToolState);
}

Result<double, Failure> tool_number_of(Channel& channel, const SystemAccess& access) {
  if (access.id <= SystemId::ActiveEdgeData) {
    return active_edge_value(channel, access);
  }
  return access.id <= SystemId::ToolPlace ? Result<double, Failure>(list_value(channel, access))
                                          : tool_value(channel, access);
}

MaybeFailure set_tool_number(Channel& channel, SystemAccess access, double value) {
  if (access.id == SystemId::ActiveEdgeData) {
    access.parameter = access.indices[0];
    access.indices = {channel.tool, channel.edge};
    access.id = SystemId::EdgeParameter;
    if (access.parameter < 1 || access.parameter >= static_cast<int>(EdgeData().size())) {
      return failure(AlarmId::IndexOne, fmt::format("$P_AD[{}]", access.parameter));
    }
    if (!channel.edge_now) {
      return no_edge(access);
    }
    (*channel.edge_now)[static_cast<std::size_t>(access.parameter)] = value;
    channel.frames_changed();
  }
  if (access.id == SystemId::EdgeParameter && access.indices[1] < 1) {
    return no_edge(access);
  }
  Tool* const known = channel.tool_to_write(access.indices[0]);
  if (MaybeFailure wrong = missing(channel, access)) {
    return wrong;
  }
  Tool& tool = *known;
  if (access.id == SystemId::EdgeParameter) {
    // Writing to an edge that is not there makes it.
    tool.edges[access.indices[1]][static_cast<std::size_t>(access.parameter)] = value;
  } else if (is_kept(access.id)) {
    tool.more[datum_of(access)] = value;
  } else if (access.id == SystemId::EdgeTeeth) {
    tool.teeth[access.indices[1]] = value;
  } else {
    (access.id == SystemId::ToolDuplo ? tool.duplo : tool.state) = value;
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik

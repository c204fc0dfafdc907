// The tool in force, and what its data make of the tip.

#include <cmath>

#include "interpreter/dialects/sinumerik/state/channel.h"

namespace g31::sinumerik {
namespace {

constexpr int kNoCompensation = number_in_group("G40");

}  // namespace

Tool* Channel::find_tool(int number) {
  const auto found = tools.find(number);
  return found != tools.end() ? &found->second : nullptr;
}

Tool* Channel::tool_to_write(int number) {
  if (loads_data && number > 0) {
    knows_tools = true;
    return &tools[number];
  }
  return find_tool(number);
}

EdgeData* Channel::find_edge(int number, int which) {
  Tool* const found = find_tool(number);
  if (found == nullptr) {
    return nullptr;
  }
  const auto row = found->edges.find(which);
  return row != found->edges.end() ? &row->second : nullptr;
}

double Channel::tool_radius() const {
  const EdgeData* const data = active_edge();
  return data != nullptr ? (*data)[EdgeDatum::kRadius] + (*data)[EdgeDatum::kRadiusWear] +
                               additive_now[EdgeDatum::kRadius - EdgeDatum::kLength1]
                         : 0.0;
}

LengthRules Channel::length_rules() const {
  const auto number = [this](std::size_t place) {
    return static_cast<int>(std::lround(numbers[place]));
  };
  return {number(length_plane_), number(turning_length_plane_), number(length_kind_),
          number(tool_parameter_mask_)};
}

ToolLengths Channel::tool_lengths() const {
  const EdgeData* const data = active_edge();
  if (data == nullptr) {
    return {};
  }
  const double type = (*data)[EdgeDatum::kType];
  const LengthRules rules = length_rules();
  ToolLengths lengths = axes_of_lengths(rules, group[Group::Plane], type);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_across = lengths.axes.at(i) == transverse_axis() && is_turning_type(type);
    const double length = (*data)[EdgeDatum::kLength1 + i];
    const double wear = (*data)[EdgeDatum::kWear1 + i];
    lengths.mm.at(i) = (is_across && (rules.diameters & 2) != 0 ? length / 2.0 : length) +
                       (is_across && (rules.diameters & 1) != 0 ? wear / 2.0 : wear) +
                       (*data)[EdgeDatum::kAdapter1 + i] + additive_now.at(i);
  }
  return lengths;
}

AxisPositions Channel::edge_offset() const {
  AxisPositions offset = AxisPositions::Zero();
  const EdgeData* const data = active_edge();
  if (data == nullptr) {
    return offset;
  }
  const ToolLengths lengths = tool_lengths();
  for (std::size_t i = 0; i < 3; ++i) {
    offset[lengths.axes.at(i)] = lengths.mm.at(i);
  }
  if (group[Group::RadiusCompensation] != kNoCompensation &&
      is_turning_type((*data)[EdgeDatum::kType])) {
    const auto [first, second] = nose_centre((*data)[EdgeDatum::kPosition]);
    offset[plane().first] -= first * tool_radius();
    offset[plane().second] -= second * tool_radius();
  }
  return offset;
}

AxisPositions Channel::tool_offset() const {
  AxisPositions offset = edge_offset();
  if (orientation.carrier != 0 && !orientation.chain) {
    offset.head<kLinearAxisCount>() =
        orientation.vectors.tool_length(linear_axes(offset), orientation.deg);
  }
  return offset;
}

}  // namespace g31::sinumerik

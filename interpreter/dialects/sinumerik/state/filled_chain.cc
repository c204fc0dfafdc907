#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/state/kinematic_chain.h"

namespace g31::sinumerik {
namespace {

/// A link of the chain, all axes at 0.
struct Link {
  std::string name;
  const char* type;
  Point vector = Point::Zero();
  std::string axis;
};

/// A rotary axis of tool carrier 1.
struct CarriedAxis {
  int number;  ///< 1 or 2
  int axis;    ///< storage index
  Point p_centre;
  Point direction;
};

/// Elements and transformation lie where those of a program hardly are.
constexpr int kFirstFilled = 170;
constexpr int kFilledTransformation = 20;

std::string axis_of(int axis) {
  return fmt::format("{}1", kAxisLetters[static_cast<std::size_t>(axis)]);
}

std::string correction_of(const CarriedAxis& axis) {
  return fmt::format("SHEET_CORR{}", axis.number);
}

/// From the machine to the end of a side and back to where it began: a correction lies behind its
/// axis on the tool's side, before it on the part's.
std::vector<Link> links_of(const std::vector<CarriedAxis>& axes, bool is_tools) {
  const char* const side = is_tools ? "SHEET_T" : "SHEET_P";
  std::vector<Link> links;
  Point p_here = Point::Zero();
  for (const CarriedAxis& axis : axes) {
    const Link turn{fmt::format("SHEET_ROT{}", axis.number), "AXIS_ROT", axis.direction,
                    axis_of(axis.axis)};
    const Link correction{correction_of(axis), "OFFSET", Point::Zero(), ""};
    links.push_back({fmt::format("{}{}", side, axis.number), "OFFSET", axis.p_centre - p_here, ""});
    links.push_back(is_tools ? turn : correction);
    links.push_back(is_tools ? correction : turn);
    p_here = axis.p_centre;
  }
  links.push_back({fmt::format("{}9", side), "OFFSET", -p_here, ""});
  return links;
}

/// Writes what follows each other from element n on.
void write_links(ChannelState& state, const std::vector<Link>& links, int& n) {
  for (std::size_t i = 0; i < links.size(); ++i, ++n) {
    const Link& link = links[i];
    state.kept_texts[{SystemId::ChainElementName, 0, {n}}] = link.name;
    state.kept_texts[{SystemId::ChainElementType, 0, {n}}] = link.type;
    state.kept_texts[{SystemId::ChainElementAxis, 0, {n}}] = link.axis;
    if (i + 1 < links.size()) {
      state.kept_texts[{SystemId::ChainElementNext, 0, {n}}] = links[i + 1].name;
    }
    for (int k = 0; k < 3; ++k) {
      state.kept_data[{SystemId::ChainElementVector, 0, {n, k}}] = link.vector[k];
    }
  }
}

std::pair<std::vector<CarriedAxis>, std::vector<CarriedAxis>> axes_of(
    const machine::KinematicVectors& v) {
  const bool has_second = v.axes[1] >= 0;
  const CarriedAxis first{1, v.axes[0],
                          v.type == machine::KinematicType::Tool ? Point(v.i2 + v.i3) : v.i2, v.v1};
  const CarriedAxis second{
      2, v.axes[1], v.type == machine::KinematicType::Part ? Point(v.i2 + v.i3) : v.i3, v.v2};
  std::vector<CarriedAxis> tool;
  std::vector<CarriedAxis> part;
  (v.type == machine::KinematicType::Part ? part : tool).push_back(first);
  if (has_second) {
    (v.type == machine::KinematicType::Tool ? tool : part).push_back(second);
  }
  return {tool, part};
}

}  // namespace

void fill_chain(ChannelState& state, const machine::KinematicVectors& vectors) {
  const auto [tool, part] = axes_of(vectors);
  std::vector<Link> links = {{"SHEET_ROOT", "OFFSET", Point::Zero(), ""}};
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    links.push_back({fmt::format("SHEET_{}", kAxisLetters[static_cast<std::size_t>(axis)]),
                     "AXIS_LIN", Point::Unit(axis), axis_of(axis)});
  }
  const std::vector<Link> of_tool = links_of(tool, true);
  links.insert(links.end(), of_tool.begin(), of_tool.end());
  int n = kFirstFilled;
  write_links(state, links, n);
  const int nt = kFilledTransformation;
  state.kept_texts[{SystemId::TransformationName, 0, {nt}}] = "SHEET";
  state.kept_texts[{SystemId::TransformationType, 0, {nt}}] = "TRAORI_DYN";
  constexpr double kBothSidesClosed = 384.0;
  state.kept_data[{SystemId::TransformationControl, 0, {nt}}] = kBothSidesClosed;
  if (!tool.empty()) {
    state.kept_texts[{SystemId::ToolChainEnd, 0, {nt}}] = of_tool.back().name;
  }
  if (!part.empty()) {
    const std::vector<Link> of_part = links_of(part, false);
    // Beside the first linear axis.
    state.kept_texts[{SystemId::ChainElementBeside, 0, {kFirstFilled + 1}}] = of_part.front().name;
    write_links(state, of_part, n);
    state.kept_texts[{SystemId::PartChainEnd, 0, {nt}}] = of_part.back().name;
  }
  for (int i = 0; i < static_cast<int>(tool.size()); ++i) {
    state.kept_texts[{SystemId::ToolCorrection, 0, {nt, i}}] =
        correction_of(tool[static_cast<std::size_t>(i)]);
  }
  for (int i = 0; i < static_cast<int>(part.size()); ++i) {
    state.kept_texts[{SystemId::PartCorrection, 0, {nt, i}}] =
        correction_of(part[static_cast<std::size_t>(i)]);
  }
}

}  // namespace g31::sinumerik

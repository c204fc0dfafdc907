#include "interpreter/dialects/sinumerik/state/kinematic_chain.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "machine/kinematics/plane_rotation.h"

namespace g31::sinumerik {
namespace {

using Indices = std::vector<int>;

std::string text_at(const ChannelState& state, SystemId id, const Indices& at) {
  const auto found = state.kept_texts.find({id, 0, at});
  return found != state.kept_texts.end() ? found->second : std::string();
}

double number_at(const ChannelState& state, SystemId id, const Indices& at) {
  const auto found = state.kept_data.find({id, 0, at});
  return found != state.kept_data.end() ? found->second : 0.0;
}

Failure wrong_chain(const std::string& what) {
  return failure(AlarmId::BadFiveAxisData, what);
}

/// A link of the chain, all axes at 0.
struct Element {
  int index = 0;
  std::string name;
  std::string parent;  ///< empty: a root
};

/// The elements by their names; of one name the first.
std::map<std::string, Element> elements_of(const ChannelState& state) {
  std::map<std::string, Element> elements;
  for (const auto& [key, name] : state.kept_texts) {
    if (key.id == SystemId::ChainElementName && !name.empty()) {
      elements.try_emplace(name, Element{key.indices.front(), name, ""});
    }
  }
  // What follows an element, and what lies beside that.
  std::map<std::string, bool> has_parent;
  for (const auto& [name, element] : elements) {
    std::string child = text_at(state, SystemId::ChainElementNext, {element.index});
    for (auto found = elements.find(child); found != elements.end() && !has_parent[child];
         found = elements.find(child)) {
      has_parent[child] = true;
      found->second.parent = name;
      child = text_at(state, SystemId::ChainElementBeside, {found->second.index});
    }
  }
  return elements;
}

/// From the first to the last element of a side.
Result<std::vector<Element>, Failure> path_of(const ChannelState& state, const ChainEnds& ends) {
  const std::map<std::string, Element> elements = elements_of(state);
  std::vector<Element> path;
  std::string name = ends.to;
  while (!name.empty()) {
    const auto found = elements.find(name);
    if (found == elements.end() || path.size() >= elements.size()) {
      return wrong_chain(fmt::format("$NK_: element \"{}\" {}", name,
                                     found == elements.end() ? "is missing" : "leads to itself"));
    }
    path.push_back(found->second);
    if (name == ends.from) {
      break;
    }
    name = found->second.parent;
  }
  if (!ends.from.empty() && (path.empty() || path.back().name != ends.from)) {
    return wrong_chain(
        fmt::format("$NK_: no way from element \"{}\" to \"{}\"", ends.from, ends.to));
  }
  std::ranges::reverse(path);
  return path;
}

/// A rotary axis of a side.
struct Joint {
  std::string name;
  int axis = -1;
  Point p_centre = Point::Zero();
  Point direction = Point::Zero();
  double basic_deg = 0.0;  ///< its position where the angle is 0
};

struct Side {
  std::vector<Joint> joints;
  Point p_end = Point::Zero();
};

/// Storage index of a machine axis, "A1" or "A"; -1: none.
int axis_named(const ChannelState& state, const std::string& name) {
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const std::string letter(1, kAxisLetters[static_cast<std::size_t>(axis)]);
    const std::string given = text_at(state, SystemId::NameOfMachineAxis, {axis});
    if (name == letter || name == (given.empty() ? letter + "1" : given)) {
      return axis;
    }
  }
  return -1;
}

/// Follows a side from element to element.
class Walk {
 public:
  explicit Walk(const ChannelState& state) : state_(state) {}

  MaybeFailure step(const Element& element) {
    const std::string type = text_at(state_, SystemId::ChainElementType, {element.index});
    Point along;
    for (int k = 0; k < 3; ++k) {
      along[k] = number_at(state_, SystemId::ChainElementVector, {element.index, k});
    }
    const double offset = number_at(state_, SystemId::ChainElementOffset, {element.index});
    if (type == "OFFSET") {
      here_.translate(along);
      return std::nullopt;
    }
    if (along.isZero(0.0)) {
      return wrong_chain(fmt::format("$NK_: element \"{}\" has no direction", element.name));
    }
    along.normalize();
    if (type == "ROT_CONST") {
      here_.rotate(machine::turn_about(along, offset));
    } else if (type == "AXIS_LIN") {
      if (!side_.joints.empty()) {
        return wrong_chain(
            fmt::format("$NK_: rotary axis \"{}\" carries linear axis \"{}\": not simulated",
                        side_.joints.back().name, element.name));
      }
      here_.translate(offset * along);
    } else if (type == "AXIS_ROT") {
      const int axis =
          axis_named(state_, text_at(state_, SystemId::ChainElementAxis, {element.index}));
      side_.joints.push_back({element.name, axis, here_.translation(), here_.linear() * along,
                              offset == 0.0 ? 0.0 : -offset});
    } else {
      return wrong_chain(
          fmt::format("$NK_: element \"{}\" has no type that is simulated", element.name));
    }
    return std::nullopt;
  }

  [[nodiscard]] Point place() const { return here_.translation(); }
  [[nodiscard]] std::size_t joints() const { return side_.joints.size(); }

  Side ended() && {
    side_.p_end = here_.translation();
    return std::move(side_);
  }

 private:
  const ChannelState& state_;
  Eigen::Isometry3d here_ = Eigen::Isometry3d::Identity();
  Side side_;
};

/// @param names  the rotary axes that take part; none: all.  Others are held at 0.
Result<Side, Failure> side_of(const ChannelState& state, const ChainEnds& ends,
                              const std::vector<std::string>& names, bool is_tools) {
  const auto path = path_of(state, ends);
  if (!path) {
    return path.error();
  }
  Walk walk(state);
  // How many joints lie before the place where the side is closed.
  std::optional<std::size_t> before;
  for (const Element& element : path.value()) {
    if (MaybeFailure wrong = walk.step(element)) {
      return *wrong;
    }
    if (!ends.closed_at.empty() && element.name == ends.closed_at) {
      before = walk.joints();
    }
  }
  if (ends.is_closed && !ends.closed_at.empty() && !before && !ends.to.empty()) {
    return wrong_chain(
        fmt::format("$NT_CLOSE_CHAIN_: \"{}\" is no element of that side", ends.closed_at));
  }
  Side side = std::move(walk).ended();
  if (ends.is_closed) {
    const Point gap = -side.p_end;
    for (std::size_t i = before.value_or(is_tools ? 0 : side.joints.size()); i < side.joints.size();
         ++i) {
      side.joints[i].p_centre += gap;
    }
    side.p_end = Point::Zero();
  }
  if (!names.empty()) {
    std::erase_if(side.joints, [&names](const Joint& joint) {
      return std::ranges::find(names, joint.name) == names.end();
    });
  }
  return side;
}

/// Where the machine has its rotary axes.
struct Sides {
  Side tool;
  Side part;
};

machine::KinematicVectors vectors_of_sides(const Sides& sides) {
  machine::KinematicVectors vectors;
  const std::vector<Joint>& head = sides.tool.joints;
  const std::vector<Joint>& table = sides.part.joints;
  if (head.size() == 1 && table.size() == 1) {
    vectors.type = machine::KinematicType::Mixed;
    vectors.i1 = -head[0].p_centre;
    vectors.i2 = head[0].p_centre - sides.tool.p_end;
    vectors.i3 = table[0].p_centre;
    vectors.i4 = sides.part.p_end - table[0].p_centre;
  } else if (table.empty()) {
    vectors.type = machine::KinematicType::Tool;
    vectors.i1 = -head[0].p_centre;
    vectors.i2 = head[0].p_centre - (head.size() == 2 ? head[1].p_centre : sides.tool.p_end);
    vectors.i3 = head.size() == 2 ? Point(head[1].p_centre - sides.tool.p_end) : Point::Zero();
  } else {
    vectors.type = machine::KinematicType::Part;
    vectors.i2 = table[0].p_centre;
    vectors.i3 = table.size() == 2 ? Point(table[1].p_centre - table[0].p_centre) : Point::Zero();
    vectors.i4 = sides.part.p_end - table.back().p_centre;
  }
  return vectors;
}

/// The data of a carrier whose vectors are those of a chain.
/// @param carrier  names and limits of its own stay
Result<ToolCarrier, Failure> on_sides(const Channel& channel, const Sides& sides,
                                      ToolCarrier carrier) {
  std::vector<Joint> joints = sides.tool.joints;
  joints.insert(joints.end(), sides.part.joints.begin(), sides.part.joints.end());
  if (joints.empty() || joints.size() > 2) {
    return wrong_chain(
        fmt::format("the chain has {} rotary axes, one or two are simulated", joints.size()));
  }
  machine::KinematicVectors vectors = vectors_of_sides(sides);
  std::array<machine::RotaryTravel, 2> travel;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!is_rotary_axis(joints[i].axis)) {
      return wrong_chain(
          fmt::format("$NK_AXIS of element \"{}\" is no rotary axis", joints[i].name));
    }
    vectors.axes.at(i) = joints[i].axis;
    (i == 0 ? vectors.v1 : vectors.v2) = joints[i].direction;
    if (const auto goes = channel.port.travel(joints[i].axis)) {
      travel.at(i) = {goes->min, goes->max};
    }
  }
  ToolCarrier on_chain = carrier_of(vectors, travel);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    on_chain.numbers.at(ToolCarrier::kBasic1 + i) = joints[i].basic_deg;
  }
  // What the chain does not say is the carrier's own.
  for (std::size_t n = ToolCarrier::kHirthOffset1; n <= ToolCarrier::kLast; ++n) {
    const bool is_limit = n >= ToolCarrier::kLower1 && n < ToolCarrier::kName;
    if (!is_limit || carrier.numbers.at(n) != 0.0) {
      on_chain.numbers.at(n) = carrier.numbers.at(n);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (!carrier.names.at(i).empty()) {
      on_chain.names.at(i) = carrier.names.at(i);
    }
  }
  return on_chain;
}

std::vector<std::string> names_at(const ChannelState& state, SystemId id, int number) {
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) {
    if (std::string name = text_at(state, id, {number, i}); !name.empty()) {
      names.push_back(std::move(name));
    }
  }
  return names;
}

Result<std::optional<ToolCarrier>, Failure> found_on(const Channel& channel,
                                                     const std::array<ChainEnds, 2>& ends,
                                                     const std::vector<std::string>& names,
                                                     const ToolCarrier& carrier) {
  const Result<Side, Failure> tool = side_of(channel, ends[0], names, true);
  if (!tool) {
    return tool.error();
  }
  const Result<Side, Failure> part = side_of(channel, ends[1], names, false);
  if (!part) {
    return part.error();
  }
  const Result<ToolCarrier, Failure> found =
      on_sides(channel, {tool.value(), part.value()}, carrier);
  if (!found) {
    return found.error();
  }
  return std::optional(found.value());
}

Result<std::optional<ToolCarrier>, Failure> transformation_on_chain(const Channel& channel, int n) {
  const std::string name = text_at(channel, SystemId::TransformationName, {n});
  if (name.empty()) {
    return std::optional<ToolCarrier>();
  }
  const std::string type = text_at(channel, SystemId::TransformationType, {n});
  if (!type.empty() && type != "TRAORI_DYN") {
    return wrong_chain(fmt::format("$NT_TRAFO_TYPE[{}]=\"{}\": TRAORI_DYN is simulated", n, type));
  }
  const std::uint32_t control = bits_of(number_at(channel, SystemId::TransformationControl, {n}));
  constexpr unsigned kClosesPart = 1U << 7U;
  constexpr unsigned kClosesTool = 1U << 8U;
  const std::array<ChainEnds, 2> ends = {
      ChainEnds{"", text_at(channel, SystemId::ToolChainEnd, {n}),
                text_at(channel, SystemId::ToolChainClosed, {n}), (control & kClosesTool) != 0},
      ChainEnds{"", text_at(channel, SystemId::PartChainEnd, {n}),
                text_at(channel, SystemId::PartChainClosed, {n}), (control & kClosesPart) != 0}};
  ToolCarrier carrier;
  carrier.names[0] = name;
  return found_on(channel, ends, names_at(channel, SystemId::TransformationAxes, n), carrier);
}

}  // namespace

std::optional<int> transformation_named(const ChannelState& state, const std::string& name) {
  for (const auto& [key, text] : state.kept_texts) {
    if (key.id == SystemId::TransformationName && !text.empty() && text == name) {
      return key.indices.front();
    }
  }
  return std::nullopt;
}

Result<std::optional<DataTransformation>, Failure> transformation_of_data(const Channel& channel,
                                                                          int n) {
  return channel.transformation_data.told(channel.numbers, n, [&channel](int axis) {
    const auto goes = channel.port.travel(axis);
    return goes ? machine::RotaryTravel{goes->min, goes->max} : machine::RotaryTravel{};
  });
}

bool is_on_chain(const ChannelState& state, int number) {
  if (number > kFirstOnChain || state.kept_texts.empty()) {
    return number > kFirstOnChain && number <= kFirstOfData;
  }
  return !text_at(state, SystemId::CarrierToolEnd, {number}).empty() ||
         !text_at(state, SystemId::CarrierPartEnd, {number}).empty();
}

Result<std::optional<ToolCarrier>, Failure> carrier_in_force(const Channel& channel, int number) {
  if (number > kFirstOfData) {
    const auto told = transformation_of_data(channel, number - kFirstOfData);
    if (!told) {
      return told.error();
    }
    return told.value() ? std::optional(told.value()->carrier) : std::nullopt;
  }
  if (number > kFirstOnChain) {
    return transformation_on_chain(channel, number - kFirstOnChain);
  }
  const auto found = channel.carriers.find(number);
  if (!is_on_chain(channel, number)) {
    return found != channel.carriers.end() ? std::optional(found->second) : std::nullopt;
  }
  const std::array<ChainEnds, 2> ends = {
      ChainEnds{text_at(channel, SystemId::CarrierToolBegin, {number}),
                text_at(channel, SystemId::CarrierToolEnd, {number}), "", true},
      ChainEnds{text_at(channel, SystemId::CarrierPartBegin, {number}),
                text_at(channel, SystemId::CarrierPartEnd, {number}), "", true}};
  return found_on(channel, ends, names_at(channel, SystemId::CarrierRotaryNames, number),
                  found != channel.carriers.end() ? found->second : ToolCarrier());
}

}  // namespace g31::sinumerik

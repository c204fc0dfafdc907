#include "machine/kinematics/kinematic_vectors.h"

#include <algorithm>
#include <string>

#include "machine/kinematics/plane_rotation.h"

namespace g31::machine {
namespace {

Eigen::Matrix3d turned(const Point& v, double deg) {
  const double length = v.norm();
  return length > 0.0 ? turn_about(Point(v / length), deg) : Eigen::Matrix3d::Identity();
}

const RotaryLine& line_of(const AxisChainSetup& chain, int axis) {
  return chain.rotary.at(static_cast<std::size_t>(axis - kLinearAxisCount));
}

/// The points of two lines that are nearest to each other.
std::array<Point, 2> feet(const RotaryLine& a, const RotaryLine& b) {
  const Point u = a.axis_M.normalized();
  const Point w = b.axis_M.normalized();
  const Point between = b.p_M_centre - a.p_M_centre;
  const double k = u.dot(w);
  const double span = 1.0 - k * k;
  return {a.p_M_centre + u * ((u.dot(between) - k * w.dot(between)) / span),
          b.p_M_centre + w * ((k * u.dot(between) - w.dot(between)) / span)};
}

/// Whether the linear axes stand between the bed and every rotary axis.
bool carries_no_linear_axis(const AxisChainSetup& chain) {
  const auto is_rotary = [](char letter) { return is_rotary_axis(axis_index(letter)); };
  // The part's side goes from the part to the bed, the tool's from the bed to the tool.
  const std::string from_part = chain.table_side + chain.tool_side;
  const auto first_linear = std::ranges::find_if_not(from_part, is_rotary);
  const auto last_linear = std::find_if_not(from_part.rbegin(), from_part.rend(), is_rotary).base();
  return first_linear == from_part.end() || std::none_of(first_linear, last_linear, is_rotary);
}

std::string rotary_letters(const KinematicVectors& vectors, bool of_tool) {
  std::string letters;  // axis 1 first
  for (std::size_t i = 0; i < 2; ++i) {
    const bool is_tools =
        vectors.type == KinematicType::Tool || (vectors.type == KinematicType::Mixed && i == 0);
    if (vectors.axes.at(i) >= 0 && is_tools == of_tool) {
      letters += kAxisLetters[static_cast<std::size_t>(vectors.axes.at(i))];
    }
  }
  return letters;
}

std::string linear_letters(const std::string& side) {
  std::string letters;
  std::ranges::copy_if(side, std::back_inserter(letters),
                       [](char letter) { return is_linear_axis(axis_index(letter)); });
  return letters;
}

}  // namespace

Point KinematicVectors::tool_length(const Point& length, const std::array<double, 2>& deg) const {
  switch (type) {
    case KinematicType::Part:
      return length;
    case KinematicType::Mixed:
      return i1 + turned(v1, deg[0]) * (i2 + length);
    case KinematicType::Tool:
      break;
  }
  return i1 + turned(v1, deg[0]) * (i2 + turned(v2, deg[1]) * (i3 + length));
}

Eigen::Matrix3d KinematicVectors::tool_turn(const std::array<double, 2>& deg) const {
  switch (type) {
    case KinematicType::Part:
      return Eigen::Matrix3d::Identity();
    case KinematicType::Mixed:
      return turned(v1, deg[0]);
    case KinematicType::Tool:
      break;
  }
  return turned(v1, deg[0]) * turned(v2, deg[1]);
}

Eigen::Isometry3d KinematicVectors::part_motion(const std::array<double, 2>& deg) const {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (type == KinematicType::Part) {
    motion.translate(i2);
    motion.rotate(turned(v1, deg[0]));
  }
  if (type != KinematicType::Tool) {
    motion.translate(i3);
    motion.rotate(turned(v2, deg[1]));
    motion.translate(i4);
  }
  return motion;
}

std::optional<KinematicVectors> vectors_of(const AxisChainSetup& chain) {
  const std::optional<OrientationAxes> axes = OrientationAxes::of(chain);
  if (!axes || !carries_no_linear_axis(chain)) {
    return std::nullopt;
  }
  KinematicVectors vectors;
  vectors.type = axes->type();
  vectors.axes = axes->axes();
  const RotaryLine& first = line_of(chain, vectors.axes[0]);
  const bool has_second = axes->count() == 2;
  const RotaryLine& second = has_second ? line_of(chain, vectors.axes[1]) : first;
  const bool is_first_tools = vectors.type != KinematicType::Part;
  const bool is_second_tools = vectors.type == KinematicType::Tool;
  vectors.v1 = (is_first_tools ? 1.0 : -1.0) * first.axis_M.normalized();
  if (has_second) {
    vectors.v2 = (is_second_tools ? 1.0 : -1.0) * second.axis_M.normalized();
  }
  std::array<Point, 2> points = {first.p_M_centre, second.p_M_centre};
  if (has_second && vectors.type != KinematicType::Mixed) {
    points = feet(first, second);
  }
  switch (vectors.type) {
    case KinematicType::Tool:
      vectors.i3 = points[1];
      vectors.i2 = points[0] - points[1];
      vectors.i1 = -(vectors.i2 + vectors.i3);
      break;
    case KinematicType::Part:
      vectors.i2 = points[0];
      vectors.i3 = points[1] - points[0];
      vectors.i4 = -(vectors.i2 + vectors.i3);
      break;
    case KinematicType::Mixed:
      vectors.i2 = points[0];
      vectors.i1 = -vectors.i2;
      vectors.i3 = points[1];
      vectors.i4 = -vectors.i3;
      break;
  }
  return vectors;
}

VectorChain chain_of(const KinematicVectors& vectors, const AxisChainSetup& linear) {
  VectorChain result;
  AxisChainSetup& chain = result.chain;
  std::string table = rotary_letters(vectors, false);
  std::ranges::reverse(table);
  chain.table_side = table + linear_letters(linear.table_side);
  chain.tool_side = linear_letters(linear.tool_side) + rotary_letters(vectors, true);
  std::array<Point, 2> points = {vectors.i2, vectors.i3};
  switch (vectors.type) {
    case KinematicType::Tool:
      points = {vectors.i3 + vectors.i2, vectors.i3};
      result.tool_shift = vectors.i1 + vectors.i2 + vectors.i3;
      break;
    case KinematicType::Part:
      points = {vectors.i2, vectors.i2 + vectors.i3};
      result.part_shift = vectors.i2 + vectors.i3 + vectors.i4;
      break;
    case KinematicType::Mixed:
      result.tool_shift = vectors.i1 + vectors.i2;
      result.part_shift = vectors.i3 + vectors.i4;
      break;
  }
  const std::array<Point, 2> v = {vectors.v1, vectors.v2};
  for (std::size_t i = 0; i < 2; ++i) {
    if (vectors.axes.at(i) < 0) {
      continue;
    }
    const bool is_tools =
        vectors.type == KinematicType::Tool || (vectors.type == KinematicType::Mixed && i == 0);
    RotaryLine& line =
        chain.rotary.at(static_cast<std::size_t>(vectors.axes.at(i) - kLinearAxisCount));
    line.p_M_centre = points.at(i);
    line.axis_M = (is_tools ? 1.0 : -1.0) * v.at(i);
  }
  return result;
}

}  // namespace g31::machine

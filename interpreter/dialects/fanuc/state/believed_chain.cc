// Parameters of five-axis machines.  Source: FANUC A-79348E pp. 72 to 84, hypothetical axes pp. 72,
// 75 and 78; values of the directions and the numbers 19700 to 19705 as commonly used.  Angles RA
// and RB of the tool's direction as those of A-78640E p. 156: RA from the 2nd linear axis to the
// 3rd, RB from the 3rd to the 1st.

#include "interpreter/dialects/fanuc/state/believed_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "interpreter/runtime/angles.h"
#include "machine/kinematics/kinematic_vectors.h"
#include "machine/kinematics/plane_rotation.h"

namespace g31::fanuc {
namespace {

using machine::KinematicType;
using machine::KinematicVectors;

constexpr int kType = 19680;
constexpr int kLast = 19714;
constexpr int kToolReference = 19697;
constexpr int kTable = 19700;        // a point of the table's axis, of two the one at the bed
constexpr int kToNextTable = 19703;  // from there to the other
constexpr int kHead = 19709;         // from the tool's holder to the axis that carries it
constexpr int kToNextHead = 19712;   // from there to the other

constexpr double kFurthestMm = 1e5;

/// The numbers of one rotary axis, from the first of its five.
struct AxisNumbers {
  int first;
  [[nodiscard]] int axis() const { return first; }
  [[nodiscard]] int direction() const { return first + 1; }
  [[nodiscard]] int inclination() const { return first + 2; }
  [[nodiscard]] int left_handed() const { return first + 3; }
  [[nodiscard]] int fixed_at() const { return first + 4; }
};
constexpr std::array<AxisNumbers, 2> kAxes = {{{19681}, {19686}}};

struct TypeRow {
  int number;
  KinematicType type;
};
constexpr TypeRow kTypes[] = {
    {2, KinematicType::Tool}, {12, KinematicType::Part}, {21, KinematicType::Mixed}};

/// A number of an axis, a direction or a type; 0 where it is out of any range.
int nearest(double value) {
  constexpr double kMost = 1000.0;
  return std::abs(value) <= kMost ? static_cast<int>(std::lround(value)) : 0;
}

bool is_tools(KinematicType type, std::size_t which) {
  return type == KinematicType::Tool || (type == KinematicType::Mixed && which == 0);
}

/// 1 to 3 along X, Y, Z; 4 to 6 inclined from X to Y, from Y to Z, from Z to X.
std::optional<Point> direction_of(int number, double inclined_deg) {
  if (number >= 1 && number <= kLinearAxisCount) {
    return Point(Point::Unit(number - 1));
  }
  if (number > kLinearAxisCount && number <= 2 * kLinearAxisCount) {
    const int from = number - kLinearAxisCount - 1;
    Point along = Point::Zero();
    along[from] = runtime::cosine_deg(inclined_deg);
    along[(from + 1) % kLinearAxisCount] = runtime::sine_deg(inclined_deg);
    return along;
  }
  return std::nullopt;
}

void fill(Parameters& parameters, int number, double value) {
  if (!parameters.has(number)) {
    parameters.set_value(number, value);
  }
}

void fill_direction(Parameters& parameters, const AxisNumbers& numbers, const Point& along) {
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    if (along == Point::Unit(axis)) {
      fill(parameters, numbers.direction(), axis + 1);
      return;
    }
  }
  for (int from = 0; from < kLinearAxisCount; ++from) {
    const int to = (from + 1) % kLinearAxisCount;
    if (along[3 - from - to] == 0.0) {
      fill(parameters, numbers.direction(), kLinearAxisCount + 1 + from);
      fill(parameters, numbers.inclination(),
           std::atan2(along[to], along[from]) * 180.0 / std::numbers::pi);
      return;
    }
  }
}

void fill_point(Parameters& parameters, int first, const Point& p) {
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    fill(parameters, first + axis, p[axis]);
  }
}

/// nullopt: out of range.
std::optional<Point> point_from(const Parameters& parameters, int first) {
  Point p;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    p[axis] = parameters.value(first + axis);
    if (!(std::abs(p[axis]) <= kFurthestMm)) {
      return std::nullopt;
    }
  }
  return p;
}

/// Where the axes of these vectors are: the first two are of the table, the others of the head.
struct Pivots {
  std::array<Point KinematicVectors::*, 2> table;
  std::array<Point KinematicVectors::*, 2> head;
};
Pivots pivots_of(KinematicType type) {
  switch (type) {
    case KinematicType::Part:
      return {{&KinematicVectors::i2, &KinematicVectors::i3}, {nullptr, nullptr}};
    case KinematicType::Mixed:
      return {{&KinematicVectors::i3, nullptr}, {&KinematicVectors::i2, nullptr}};
    case KinematicType::Tool:
      break;
  }
  return {{nullptr, nullptr}, {&KinematicVectors::i3, &KinematicVectors::i2}};
}

constexpr std::array<int, 2> kTablePoints = {kTable, kToNextTable};
constexpr std::array<int, 2> kHeadPoints = {kHead, kToNextHead};

/// The direction of an axis, right-handed for the tool against the part; the sheet's where no
/// parameter gives one.
std::optional<Point> iso_direction(const Parameters& parameters, const AxisNumbers& numbers,
                                   bool turns_tool, const machine::AxisChainSetup& sheet) {
  const int axis = nearest(parameters.value(numbers.axis())) - 1;
  const int number = nearest(parameters.value(numbers.direction()));
  const double inclined_deg = parameters.value(numbers.inclination());
  if (!(std::abs(inclined_deg) <= 360.0)) {
    return std::nullopt;
  }
  if (number == 0) {
    return is_rotary_axis(axis)
               ? std::optional(
                     sheet.rotary.at(static_cast<std::size_t>(axis - kLinearAxisCount)).axis_M)
               : std::nullopt;
  }
  const auto along = direction_of(number, inclined_deg);
  const bool is_left = parameters.value(numbers.left_handed()) != 0.0;
  // A table turns the part: left-handed for it is right-handed for the tool.
  return along ? std::optional(Point(is_left == turns_tool ? -*along : *along)) : std::nullopt;
}

/// Whether 19696 has axis 1 or 2 stand at an angle for good.
bool is_hypothetical(const Parameters& parameters, std::size_t which) {
  return parameters.is_on(which == 0 ? ParameterId::FirstIsNone : ParameterId::SecondIsNone);
}

std::optional<KinematicVectors> vectors_from(const Parameters& parameters,
                                             const machine::AxisChainSetup& sheet) {
  const int number = nearest(parameters.value(kType));
  const auto* const row = std::ranges::find(kTypes, number, &TypeRow::number);
  if (row == std::end(kTypes)) {
    return std::nullopt;
  }
  KinematicVectors vectors;
  vectors.type = row->type;
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    const int axis = nearest(parameters.value(kAxes.at(i).axis())) - 1;
    const bool is_fixed = is_hypothetical(parameters, i);
    if (axis < 0 && i == 1 && !is_fixed) {
      continue;  // there is one only
    }
    if (is_fixed ? axis >= 0 : !is_rotary_axis(axis)) {
      return std::nullopt;
    }
    const bool turns_tool = is_tools(vectors.type, i);
    const auto along = iso_direction(parameters, kAxes.at(i), turns_tool, sheet);
    if (!along) {
      return std::nullopt;
    }
    vectors.axes.at(i) = axis;
    (i == 0 ? vectors.v1 : vectors.v2) = turns_tool ? *along : Point(-*along);
  }
  const Pivots pivots = pivots_of(vectors.type);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto table = point_from(parameters, kTablePoints.at(i));
    const auto head = point_from(parameters, kHeadPoints.at(i));
    if (!table || !head) {
      return std::nullopt;
    }
    if (pivots.table.at(i) != nullptr) {
      vectors.*pivots.table.at(i) = *table;
    }
    if (pivots.head.at(i) != nullptr) {
      vectors.*pivots.head.at(i) = *head;
    }
  }
  return vectors;
}

/// 19697 to 19699: from a tool along Z to where it points with all rotary axes at 0, RA about X
/// before RB about Y; nullopt: no such direction.
std::optional<Eigen::Isometry3d> tool_direction(const Parameters& parameters) {
  const int number = nearest(parameters.value(kToolReference));
  const double ra = parameters.value(kToolReference + 1);
  const double rb = parameters.value(kToolReference + 2);
  if (number < 0 || number > kLinearAxisCount || !(std::abs(ra) <= 360.0) ||
      !(std::abs(rb) <= 360.0)) {
    return std::nullopt;
  }
  const Eigen::Matrix3d reference = number == 1   ? machine::turn_about({1, 90.0})
                                    : number == 2 ? machine::turn_about({0, -90.0})
                                                  : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  Eigen::Isometry3d held = Eigen::Isometry3d::Identity();
  held.linear() = machine::turn_about({1, rb}) * machine::turn_about({0, ra}) * reference;
  return held;
}

/// A turn about a line.
Eigen::Isometry3d turned_about(const Point& centre, const Point& along, double deg) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.translate(centre);
  turn.rotate(machine::turn_about(along.normalized(), deg));
  turn.translate(-centre);
  return turn;
}

/// Takes axis 1 or 2, which stands at an angle for good, out of the vectors: what it carries lies
/// as it has turned it, places of the part count from there.
/// @param tool_at_rest  how the tool is held
void hold_axis(KinematicVectors& vectors, std::size_t which, double deg,
               Eigen::Isometry3d& tool_at_rest) {
  const bool has_both = !vectors.v1.isZero(0.0) && !vectors.v2.isZero(0.0);
  const bool is_head = is_tools(vectors.type, which);
  const Point centre1 =
      vectors.type == KinematicType::Tool ? Point(vectors.i3 + vectors.i2) : vectors.i2;
  const Point centre2 =
      vectors.type == KinematicType::Part ? Point(vectors.i2 + vectors.i3) : vectors.i3;
  const Eigen::Isometry3d held =
      turned_about(which == 0 ? centre1 : centre2, which == 0 ? vectors.v1 : vectors.v2, deg);
  if (is_head) {
    tool_at_rest = held * tool_at_rest;
  }
  KinematicVectors left;
  if (has_both) {
    const std::size_t other = 1 - which;
    left.type = is_tools(vectors.type, other) ? KinematicType::Tool : KinematicType::Part;
    left.axes[0] = vectors.axes.at(other);
    left.v1 = other == 0 ? vectors.v1 : vectors.v2;
    left.i2 = other == 0 ? centre1 : centre2;
    // Axis 2 of two heads or two tables goes along with axis 1.
    if (which == 0 && vectors.type != KinematicType::Mixed) {
      left.v1 = held.linear() * left.v1;
      left.i2 = held * left.i2;
    }
  }
  vectors = left;
}

}  // namespace

void fill_kinematics(Parameters& parameters, const machine::AxisChainSetup& sheet) {
  const auto vectors = machine::vectors_of(sheet);
  if (!vectors) {
    return;
  }
  const auto* const type = std::ranges::find(kTypes, vectors->type, &TypeRow::type);
  fill(parameters, kType, type->number);
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    const int axis = vectors->axes.at(i);
    if (axis < 0) {
      continue;
    }
    const bool turns_tool = is_tools(vectors->type, i);
    const Point& v = i == 0 ? vectors->v1 : vectors->v2;
    fill(parameters, kAxes.at(i).axis(), axis + 1);
    fill(parameters, kAxes.at(i).left_handed(), turns_tool ? 0.0 : 1.0);
    fill_direction(parameters, kAxes.at(i), turns_tool ? v : Point(-v));
  }
  const Pivots pivots = pivots_of(vectors->type);
  for (std::size_t i = 0; i < 2; ++i) {
    if (pivots.table.at(i) != nullptr) {
      fill_point(parameters, kTablePoints.at(i), *vectors.*pivots.table.at(i));
    }
    if (pivots.head.at(i) != nullptr) {
      fill_point(parameters, kHeadPoints.at(i), *vectors.*pivots.head.at(i));
    }
  }
}

BelievedMachine believed_machine(const Parameters& parameters,
                                 const machine::AxisChainSetup& sheet) {
  Parameters as_sheet;
  fill_kinematics(as_sheet, sheet);
  bool is_sheet = !is_hypothetical(parameters, 0) && !is_hypothetical(parameters, 1);
  for (int number = kType; number <= kLast; ++number) {
    is_sheet = is_sheet && parameters.value(number) == as_sheet.value(number);
  }
  if (is_sheet) {
    return {sheet};
  }
  auto vectors = vectors_from(parameters, sheet);
  const auto direction = tool_direction(parameters);
  if (!vectors || !direction ||
      (is_hypothetical(parameters, 0) && is_hypothetical(parameters, 1))) {
    return {};
  }
  BelievedMachine believed;
  believed.tool_at_rest = *direction;
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    if (is_hypothetical(parameters, i)) {
      const double deg = parameters.value(kAxes.at(i).fixed_at());
      if (!(std::abs(deg) <= 360.0)) {
        return {};
      }
      hold_axis(*vectors, i, deg, believed.tool_at_rest);
    }
  }
  believed.chain = machine::chain_of(*vectors, sheet).chain;
  return machine::OrientationAxes::of(believed.chain) ? believed : BelievedMachine();
}

}  // namespace g31::fanuc

#include "interpreter/dialects/sinumerik/state/transformation_data.h"

#include <string>

#include <fmt/format.h>

namespace g31::sinumerik {
namespace {

constexpr int kOnCarrier = 72;

struct TypeOfData {
  int number;
  machine::KinematicType type;
};
constexpr TypeOfData kTypesOfData[] = {{24, machine::KinematicType::Tool},
                                       {40, machine::KinematicType::Part},
                                       {56, machine::KinematicType::Mixed}};

/// A whole number among machine data.
int whole(double value) {
  return static_cast<int>(value);
}

Point point_from(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

Failure wrong_data(int n, int error, const char* what) {
  return failure(AlarmId::BadFiveAxisData, fmt::format("TRAORI({}), error {}: {}", n, error, what));
}

/// Which of the vectors lie where in the data.
machine::KinematicVectors placed(machine::KinematicType type, const Point& part_offset,
                                 const Point& base_tool, const Point& joint,
                                 const Point& joint_of_part) {
  machine::KinematicVectors vectors;
  vectors.type = type;
  switch (type) {
    case machine::KinematicType::Tool:
      vectors.i1 = part_offset;
      vectors.i2 = joint;
      vectors.i3 = base_tool;
      break;
    case machine::KinematicType::Part:
      vectors.i2 = base_tool;
      vectors.i3 = joint_of_part;
      vectors.i4 = part_offset;
      break;
    case machine::KinematicType::Mixed:
      vectors.i1 = joint;
      vectors.i2 = base_tool;
      vectors.i3 = joint_of_part;
      vectors.i4 = part_offset;
      break;
  }
  return vectors;
}

}  // namespace

TransformationData::TransformationData(const Globals& globals) {
  for (int n = 1; n <= kCount; ++n) {
    const auto place = [&](const char* name) {
      return globals.place(fmt::format("$MC_{}_{}", name, n));
    };
    places_.at(static_cast<std::size_t>(n - 1)) = {place("TRAFO_TYPE"),
                                                   place("TRAFO_AXES_IN"),
                                                   place("TRAFO5_PART_OFFSET"),
                                                   place("TRAFO5_ROT_AX_OFFSET"),
                                                   place("TRAFO5_ROT_SIGN_IS_PLUS"),
                                                   place("TRAFO5_BASE_TOOL"),
                                                   place("TRAFO5_JOINT_OFFSET_PART"),
                                                   place("TRAFO5_JOINT_OFFSET"),
                                                   place("TRAFO5_AXIS1"),
                                                   place("TRAFO5_AXIS2"),
                                                   place("TRAFO5_BASE_ORIENT"),
                                                   place("TRAFO5_TCARR_NO")};
  }
}

void TransformationData::take(const std::array<int, 2>& axes, std::vector<double>& numbers) const {
  const Places& at = places_.front();
  numbers[at.type] = kOnCarrier;
  numbers[at.carrier] = 1;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    numbers[at.axes + kLinearAxisCount + i] = axes.at(i) + 1;
  }
}

Result<int, Failure> TransformationData::carrier_of(const std::vector<double>& numbers,
                                                    int n) const {
  if (n < 1 || n > kCount) {
    return n;
  }
  const Places& at = places_.at(static_cast<std::size_t>(n - 1));
  const int type = whole(numbers[at.type]);
  if (type == 0) {
    return n;
  }
  if (type == kOnCarrier) {
    return whole(numbers[at.carrier]);
  }
  for (const TypeOfData& row : kTypesOfData) {
    if (row.number == type) {
      return kFirstOfData + n;
    }
  }
  return failure(AlarmId::TransformationMissing,
                 fmt::format("TRAORI({0}): type {1} of $MC_TRAFO_TYPE_{0} is not simulated, "
                             "24, 40, 56 and 72 are",
                             n, type));
}

Result<std::optional<DataTransformation>, Failure> TransformationData::told(
    const std::vector<double>& numbers, int n,
    const std::function<machine::RotaryTravel(int)>& travel_of) const {
  const auto taken = carrier_of(numbers, n);
  if (!taken) {
    return taken.error();
  }
  if (n < 1 || n > kCount || taken.value() != kFirstOfData + n) {
    return std::optional<DataTransformation>();
  }
  const Places& at = places_.at(static_cast<std::size_t>(n - 1));
  machine::KinematicType type = machine::KinematicType::Tool;
  for (const TypeOfData& row : kTypesOfData) {
    type = row.number == whole(numbers[at.type]) ? row.type : type;
  }
  machine::KinematicVectors vectors =
      placed(type, point_from(numbers, at.part_offset), point_from(numbers, at.base_tool),
             point_from(numbers, at.joint), point_from(numbers, at.joint_of_part));
  std::array<machine::RotaryTravel, 2> travel;
  const std::array<std::size_t, 2> directions = {at.axis1, at.axis2};
  for (std::size_t i = 0; i < 2; ++i) {
    const int axis = whole(numbers[at.axes + kLinearAxisCount + i]) - 1;
    if (axis < 0) {
      if (i == 0 || type == machine::KinematicType::Mixed) {
        return wrong_data(n, 5, "$MC_TRAFO_AXES_IN names no rotary axis");
      }
      continue;
    }
    const Point along = point_from(numbers, directions.at(i));
    if (along.isZero(0.0)) {
      return wrong_data(n, static_cast<int>(i) + 1, "$MC_TRAFO5_AXIS1 or AXIS2 is 0");
    }
    (i == 0 ? vectors.v1 : vectors.v2) = numbers[at.is_plus + i] != 0.0 ? along : Point(-along);
    vectors.axes.at(i) = axis;
    if (is_rotary_axis(axis)) {
      travel.at(i) = travel_of(axis);
    }
  }
  if (!orientation_of(vectors)) {
    return wrong_data(n, 4, "the directions of the axes are parallel");
  }
  const Point orientation = point_from(numbers, at.orientation);
  if (orientation.isZero(0.0)) {
    return wrong_data(n, 3, "$MC_TRAFO5_BASE_ORIENT is 0");
  }
  DataTransformation told{sinumerik::carrier_of(vectors, travel), orientation};
  for (std::size_t i = 0; i < 2; ++i) {
    told.carrier.numbers.at(ToolCarrier::kBasic1 + i) = numbers[at.basic_deg + i];
  }
  return std::optional(told);
}

}  // namespace g31::sinumerik

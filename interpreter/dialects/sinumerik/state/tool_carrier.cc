#include "interpreter/dialects/sinumerik/state/tool_carrier.h"

#include <algorithm>

namespace g31::sinumerik {
namespace {

/// Where $TC_CARRn begin that are components of a vector, and their fine offsets; 0: none.
struct VectorPlace {
  Point machine::KinematicVectors::*member;
  std::size_t first;
  std::size_t fine;
};
constexpr VectorPlace kVectors[] = {
    {&machine::KinematicVectors::i1, 1, 41},  {&machine::KinematicVectors::i2, 4, 44},
    {&machine::KinematicVectors::v1, 7, 0},   {&machine::KinematicVectors::v2, 10, 0},
    {&machine::KinematicVectors::i3, 15, 55}, {&machine::KinematicVectors::i4, 18, 58},
};

/// deg: limits of an axis without end, as $MA_POS_LIMIT_PLUS has them.
constexpr double kEndless = 1e8;

Point point_at(const std::array<double, ToolCarrier::kLast + 1>& numbers, std::size_t first) {
  return {numbers.at(first), numbers.at(first + 1), numbers.at(first + 2)};
}

std::optional<machine::KinematicType> type_of(const std::string& kind) {
  const char letter = kind.size() == 1 ? static_cast<char>(kind[0] & ~0x20) : '?';
  switch (letter) {
    case 'T':
      return machine::KinematicType::Tool;
    case 'P':
      return machine::KinematicType::Part;
    case 'M':
      return machine::KinematicType::Mixed;
    default:
      return std::nullopt;
  }
}

std::string kind_of(machine::KinematicType type) {
  return type == machine::KinematicType::Tool   ? "T"
         : type == machine::KinematicType::Part ? "P"
                                                : "M";
}

}  // namespace

Result<machine::KinematicVectors, Failure> ToolCarrier::vectors(bool with_fine) const {
  const std::optional<machine::KinematicType> type = type_of(kind);
  if (!type) {
    return failure(AlarmId::BadCarrierKind, kind);
  }
  machine::KinematicVectors vectors;
  vectors.type = *type;
  vectors.axes = axes;
  for (const VectorPlace& place : kVectors) {
    vectors.*place.member = point_at(numbers, place.first);
    if (with_fine && place.fine != 0) {
      vectors.*place.member += point_at(numbers, place.fine);
    }
  }
  return vectors;
}

double ToolCarrier::basic_position(std::size_t i, bool with_fine) const {
  return numbers.at(kBasic1 + i) + (with_fine ? numbers.at(kFineBasic1 + i) : 0.0);
}

ToolCarrier carrier_of(const machine::KinematicVectors& vectors,
                       const std::array<machine::RotaryTravel, 2>& travel) {
  ToolCarrier carrier;
  for (const VectorPlace& place : kVectors) {
    for (std::size_t i = 0; i < 3; ++i) {
      carrier.numbers.at(place.first + i) = (vectors.*place.member)[static_cast<int>(i)];
    }
  }
  carrier.axes = vectors.axes;
  carrier.kind = kind_of(vectors.type);
  for (std::size_t i = 0; i < 2; ++i) {
    if (vectors.axes.at(i) >= 0) {
      carrier.names.at(1 + i) = kAxisLetters[static_cast<std::size_t>(vectors.axes.at(i))];
      carrier.numbers.at(ToolCarrier::kLower1 + i) = std::max(travel.at(i).lower, -kEndless);
      carrier.numbers.at(ToolCarrier::kUpper1 + i) = std::min(travel.at(i).upper, kEndless);
    }
  }
  return carrier;
}

std::optional<machine::OrientationAxes> orientation_of(const machine::KinematicVectors& vectors) {
  const bool has_second = !vectors.v2.isZero(0.0);
  if (vectors.v1.isZero(0.0)) {
    return std::nullopt;
  }
  const bool is_first_tools = vectors.type != machine::KinematicType::Part;
  const bool is_second_tools = vectors.type == machine::KinematicType::Tool;
  const Point first = (is_first_tools ? 1.0 : -1.0) * vectors.v1;
  const Point second = (is_second_tools ? 1.0 : -1.0) * vectors.v2;
  constexpr double kParallel = 1e-6;
  if (has_second && first.cross(second).norm() < kParallel * first.norm() * second.norm()) {
    return std::nullopt;
  }
  // Which axes of the machine they are does not matter here.
  return machine::OrientationAxes(vectors.type, {0, has_second ? 1 : -1},
                                  {first, has_second ? second : Point(Point::UnitZ())});
}

}  // namespace g31::sinumerik

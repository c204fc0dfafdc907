#include "interpreter/dialects/sinumerik/state/tool_lengths.h"

#include <utility>

namespace g31::sinumerik {
namespace {

constexpr int kFirstPlane = 17;
constexpr int kLastPlane = 19;
constexpr int kAllAsMills = 1;
constexpr int kAllAsTurningTools = 2;

/// 1st axis, 2nd axis, normal of G17, G18 and G19.
constexpr std::array<std::array<int, 3>, 3> kPlanes = {{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};

}  // namespace

ToolLengths axes_of_lengths(const LengthRules& rules, int group_number, double type) {
  const int wanted =
      is_turning_type(type) && rules.turning_plane != 0 ? rules.turning_plane : rules.plane;
  const auto is_plane = [](int number) { return number >= kFirstPlane && number <= kLastPlane; };
  const bool is_swapped = wanted >= -kLastPlane && is_plane(-wanted);
  const bool is_fixed = is_swapped || is_plane(wanted);
  const int plane = is_swapped ? -wanted : wanted;
  const auto row = static_cast<std::size_t>(is_fixed ? plane - kFirstPlane : group_number - 1);
  const bool as_turning_tool =
      rules.kind == kAllAsTurningTools || (rules.kind != kAllAsMills && is_turning_type(type));
  auto [first, second, normal] = kPlanes.at(row);
  if (is_swapped) {
    std::swap(first, second);
  }
  ToolLengths lengths;
  lengths.axes =
      as_turning_tool ? std::array{second, first, normal} : std::array{normal, second, first};
  lengths.as_turning_tool = as_turning_tool;
  return lengths;
}

std::array<double, 2> nose_centre(double position) {
  constexpr std::array<std::array<double, 2>, 10> kFromTip = {{{0.0, 0.0},
                                                               {-1.0, -1.0},
                                                               {1.0, -1.0},
                                                               {1.0, 1.0},
                                                               {-1.0, 1.0},
                                                               {-1.0, 0.0},
                                                               {0.0, -1.0},
                                                               {1.0, 0.0},
                                                               {0.0, 1.0},
                                                               {0.0, 0.0}}};
  const bool is_one = position >= 0.0 && position < static_cast<double>(kFromTip.size());
  return is_one ? kFromTip.at(static_cast<std::size_t>(position)) : std::array{0.0, 0.0};
}

}  // namespace g31::sinumerik

#include "machine/base/nearest_name.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace g31::nearest_name_test {
namespace {

TEST(EditDistance, CountsInsertionsOmissionsReplacementsAndSwaps) {
  struct Case {
    std::string_view a;
    std::string_view b;
    std::size_t distance;
  };
  constexpr Case kCases[] = {
      {"", "", 0},         {"", "bore", 4},          {"bore", "", 4},         {"bore", "bore", 0},
      {"bore", "bor", 1},  {"bore", "bored", 1},     {"bore", "bare", 1},     {"ring", "rign", 1},
      {"abcd", "badc", 2}, {"kitten", "sitting", 3}, {"height", "length", 3},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(std::string(c.a) + " " + std::string(c.b));
    EXPECT_EQ(edit_distance(c.a, c.b), c.distance);
    EXPECT_EQ(edit_distance(c.b, c.a), c.distance);
  }
}

TEST(NearestName, FindsWhatWasMeantAndNothingElse) {
  constexpr std::array<std::string_view, 5> kKnown = {"bore", "outer_diameter", "height", "x", "y"};
  struct Case {
    std::string_view unknown;
    std::optional<std::string_view> nearest;
  };
  constexpr Case kCases[] = {
      {"bor", "bore"},      {"outer_dia", std::nullopt}, {"outerdiameter", "outer_diameter"},
      {"hieght", "height"}, {"colour", std::nullopt},    {"", std::nullopt},
      {"z", std::nullopt},  {"height", "height"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.unknown);
    EXPECT_EQ(nearest_name(c.unknown, kKnown), c.nearest);
  }
  EXPECT_EQ(nearest_name("bore", {}), std::nullopt);
}

}  // namespace
}  // namespace g31::nearest_name_test

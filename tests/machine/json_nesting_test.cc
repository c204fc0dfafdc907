#include "machine/base/json_nesting.h"

#include <string>

#include <gtest/gtest.h>

namespace g31::json_nesting_test {
namespace {

std::string lists(std::size_t depth) {
  return std::string(depth, '[') + std::string(depth, ']');
}

TEST(JsonNesting, CountsListsAndObjectsInsideOneAnother) {
  EXPECT_FALSE(nests_too_deep(lists(kDeepestJson)));
  EXPECT_TRUE(nests_too_deep(lists(kDeepestJson + 1)));
  std::string mixed = R"({"a":)" + lists(kDeepestJson - 1) + "}";
  EXPECT_FALSE(nests_too_deep(mixed));
  EXPECT_TRUE(nests_too_deep("[" + mixed + "]"));
}

TEST(JsonNesting, ThoseBesideOneAnotherAreNotDeep) {
  std::string row = "[";
  for (int i = 0; i < 1000; ++i) {
    row += "[],{},";
  }
  EXPECT_FALSE(nests_too_deep(row + "[]]"));
}

TEST(JsonNesting, BracketsOfTextsDoNotCount) {
  const std::string brackets(kDeepestJson + 1, '[');
  EXPECT_FALSE(nests_too_deep(R"(["\")" + brackets + R"("])"));
  EXPECT_TRUE(nests_too_deep(R"(["\\")" + brackets));
}

TEST(JsonNesting, TextsThatAreNoJsonHaveADepthToo) {
  EXPECT_FALSE(nests_too_deep("]]]}"));
  EXPECT_FALSE(nests_too_deep("\"\\"));
  EXPECT_TRUE(nests_too_deep("]" + lists(kDeepestJson + 1)));
}

}  // namespace
}  // namespace g31::json_nesting_test

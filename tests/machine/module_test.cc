#include "machine/base/module.h"

#include <gtest/gtest.h>

namespace g31 {
namespace {

TEST(FindInModule, AModuleThatIsNotThereIsNamed) {
  const ModuleFunction found = find_in_module("g31_nowhere.so", "g31_nothing");
  EXPECT_EQ(found.address, nullptr);
  EXPECT_NE(found.why_not.find("g31_nowhere.so"), std::string::npos) << found.why_not;
}

TEST(FindInModule, AFunctionThatAModuleLacksIsNamed) {
  // A library that is always there.
  const ModuleFunction found = find_in_module("libm.so.6", "g31_nothing");
  EXPECT_EQ(found.address, nullptr);
  EXPECT_NE(found.why_not.find("g31_nothing"), std::string::npos) << found.why_not;
}

TEST(FindInModule, AFunctionIsFoundAgainAndAgain) {
  const ModuleFunction first = find_in_module("libm.so.6", "fabs");
  const ModuleFunction second = find_in_module("libm.so.6", "fabs");
  ASSERT_NE(first.address, nullptr) << first.why_not;
  EXPECT_EQ(first.address, second.address);
  EXPECT_EQ(reinterpret_cast<double (*)(double)>(first.address)(-3.0), 3.0);
}

}  // namespace
}  // namespace g31

#include "machine/base/module.h"

#include <gtest/gtest.h>

namespace g31 {
namespace {

Module module_in(const std::string& file) {
  return {.file = file, .does = "counts", .package = "libcounting1"};
}

TEST(FindInModule, AModuleThatIsNotThereIsNamed) {
  const ModuleFunction found = find_in_module(module_in("g31_nowhere.so"), "g31_nothing");
  EXPECT_EQ(found.address, nullptr);
  EXPECT_EQ(found.why_not,
            "the module that counts cannot be loaded (g31_nowhere.so: cannot open shared object "
            "file: No such file or directory); it is a part of g31: install g31 again");
}

TEST(FindInModule, AFunctionThatAModuleLacksIsNamed) {
  // A library that is always there.
  const ModuleFunction found = find_in_module(module_in("libm.so.6"), "g31_nothing");
  EXPECT_EQ(found.address, nullptr);
  EXPECT_NE(found.why_not.find("g31_nothing"), std::string::npos) << found.why_not;
}

TEST(FindInModule, AFunctionIsFoundAgainAndAgain) {
  const ModuleFunction first = find_in_module(module_in("libm.so.6"), "fabs");
  const ModuleFunction second = find_in_module(module_in("libm.so.6"), "fabs");
  ASSERT_NE(first.address, nullptr) << first.why_not;
  EXPECT_EQ(first.address, second.address);
  EXPECT_EQ(reinterpret_cast<double (*)(double)>(first.address)(-3.0), 3.0);
}

TEST(WhatHelps, ALibraryThatIsMissingIsInAPackageTheModuleItselfInNone) {
  const Module module = module_in("g31_counts.so");
  EXPECT_EQ(what_helps(module, "libcounting.so.1: cannot open shared object file"),
            "install libcounting1");
  EXPECT_EQ(what_helps(module, "../modules/g31_counts.so: file too short"),
            "it is a part of g31: install g31 again");
}

}  // namespace
}  // namespace g31

// The programs of tests/conformance, each with what must come of it in comments of its own.
// tests/support/conformance_file.h says how they are written.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/conformance_run.h"

namespace g31::conformance_test {
namespace {

using testing::ConformanceCase;

const std::string kFolder = "tests/conformance/fanuc";

class FanucConformance : public ::testing::TestWithParam<std::string> {};

TEST_P(FanucConformance, Holds) {
  const std::string path = kFolder + "/" + GetParam() + ".nc";
  const auto cases = testing::read_conformance_file(path);
  ASSERT_TRUE(cases) << cases.error();
  for (const ConformanceCase& test : cases.value()) {
    for (const std::string& control : test.controls) {
      testing::expect_case_holds(test, control, "case.nc", path,
                                 fmt::format("{} on {}", test.title.text, control));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fanuc, FanucConformance, ::testing::ValuesIn(testing::case_files(kFolder)),
                         [](const auto& test) { return test.param; });

TEST(ConformanceFiles, AreThere) {
  EXPECT_GE(testing::case_files(kFolder).size(), 17U) << "no programs in " << kFolder;
}

}  // namespace
}  // namespace g31::conformance_test

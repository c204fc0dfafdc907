// The programs of tests/conformance/sinumerik, each with what must come of it in comments.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/conformance_run.h"

namespace g31::sinumerik_conformance_test {
namespace {

using testing::ConformanceCase;

const std::string kFolder = "tests/conformance/sinumerik";
const std::string kControl = "sinumerik-828d";

class SinumerikConformance : public ::testing::TestWithParam<std::string> {};

TEST_P(SinumerikConformance, Holds) {
  const std::string path = kFolder + "/" + GetParam() + ".mpf";
  const auto cases = testing::read_conformance_file(path);
  ASSERT_TRUE(cases) << cases.error();
  for (const ConformanceCase& test : cases.value()) {
    testing::expect_case_holds(test, kControl, "case.mpf", path, test.title.text);
  }
}

INSTANTIATE_TEST_SUITE_P(Sinumerik, SinumerikConformance,
                         ::testing::ValuesIn(testing::case_files(kFolder)),
                         [](const auto& test) { return test.param; });

TEST(SinumerikConformanceFiles, AreThere) {
  EXPECT_GE(testing::case_files(kFolder).size(), 8U) << "no programs in " << kFolder;
}

}  // namespace
}  // namespace g31::sinumerik_conformance_test

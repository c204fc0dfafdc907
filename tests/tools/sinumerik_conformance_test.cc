// The programs of tests/conformance/sinumerik, each with what must come of it in comments.

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/conformance_run.h"

namespace g31 {
namespace {

using testing::ConformanceCase;

const std::string kFolder = "tests/conformance/sinumerik";
const std::string kControl = "sinumerik-828d";

std::vector<std::string> file_names() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder, none)) {
    names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

class SinumerikConformance : public ::testing::TestWithParam<std::string> {};

TEST_P(SinumerikConformance, Holds) {
  const std::string path = kFolder + "/" + GetParam() + ".mpf";
  const auto cases = testing::ConformanceReader(path).read();
  ASSERT_TRUE(cases) << cases.error();
  for (const ConformanceCase& test : cases.value()) {
    const bool alarm_expected = std::ranges::any_of(
        test.expectations, [](const auto& row) { return row.text.starts_with("ALARM"); });
    const testing::Observed seen = testing::run_case(test, kControl, "case.mpf");
    EXPECT_TRUE(alarm_expected || (seen.alarm == 0 && !seen.run.document.empty())) << fmt::format(
        "{}:{}: ({}) does not run: {}", path, test.title.line, test.title.text, seen.run.errors);
    for (const ConformanceCase::Row& row : test.expectations) {
      const std::string wrong = testing::mismatch(row.text, seen);
      EXPECT_TRUE(wrong.empty()) << fmt::format("{}:{}: ({}) {}, not: {}", path, row.line,
                                                test.title.text, wrong, row.text);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sinumerik, SinumerikConformance, ::testing::ValuesIn(file_names()),
                         [](const auto& test) { return test.param; });

TEST(SinumerikConformanceFiles, AreThere) {
  EXPECT_GE(file_names().size(), 8U) << "no programs in " << kFolder;
}

}  // namespace
}  // namespace g31

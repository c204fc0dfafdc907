// The programs of tests/conformance, each with what must come of it in comments of its own.
// tests/support/conformance_file.h says how they are written.

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/conformance_run.h"

namespace g31 {
namespace {

using testing::ConformanceCase;
using testing::Observed;

const std::string kFolder = "tests/conformance/fanuc";

std::vector<std::string> file_names() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder, none)) {
    names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

class FanucConformance : public ::testing::TestWithParam<std::string> {};

TEST_P(FanucConformance, Holds) {
  const std::string path = kFolder + "/" + GetParam() + ".nc";
  const auto cases = testing::ConformanceReader(path).read();
  ASSERT_TRUE(cases) << cases.error();
  for (const ConformanceCase& test : cases.value()) {
    const bool alarm_expected = std::ranges::any_of(
        test.expectations, [](const auto& row) { return row.text.starts_with("ALARM"); });
    for (const std::string& control : test.controls) {
      const Observed seen = run_case(test, control, "case.nc");
      const std::string place = fmt::format("{} on {}", test.title.text, control);
      EXPECT_TRUE(alarm_expected || (seen.alarm == 0 && !seen.run.document.empty())) << fmt::format(
          "{}:{}: ({}) does not run: {}", path, test.title.line, place, seen.run.errors);
      for (const ConformanceCase::Row& row : test.expectations) {
        const std::string wrong = testing::mismatch(row.text, seen);
        EXPECT_TRUE(wrong.empty())
            << fmt::format("{}:{}: ({}) {}, not: {}", path, row.line, place, wrong, row.text);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fanuc, FanucConformance, ::testing::ValuesIn(file_names()),
                         [](const auto& test) { return test.param; });

TEST(ConformanceFiles, AreThere) {
  EXPECT_GE(file_names().size(), 17U) << "no programs in " << kFolder;
}

}  // namespace
}  // namespace g31

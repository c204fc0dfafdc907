// The programs of figures 6, 9, 12, 15 and 18 of Hirose's paper print figures 7, 10, 13, 16 and 19.
// The files under golden/ are written from the paper, in the frame that macros/README.md describes.

#include <cstdio>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/original_listings.h"
#include "tests/support/run_program.h"

namespace g31::hirose_figures_test {
namespace {

using testing::original_listings;
using testing::run_program;
using testing::RunOutput;
using testing::text_of;

struct Figure {
  const char* program;
  const char* printout;
};

/// What ctest shows of it.
void PrintTo(const Figure& figure, std::ostream* out) {
  *out << figure.program;
}

class HiroseFigures : public ::testing::TestWithParam<Figure> {
 protected:
  static RunOutput run(const std::vector<std::string>& libraries) {
    const std::string folder = "parts/library/hirose_figures/";
    const std::string figure = folder + "figure_" + GetParam().program;
    cli::RunOptions options;
    options.programs = {figure + ".nc"};
    options.setups = {folder + "machine.toml", figure + ".toml"};
    options.libraries = libraries;
    return run_program(options);
  }

  static void expect_printout(const RunOutput& output) {
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const std::string golden =
        text_of(std::string("tests/tools/golden/figure_") + GetParam().printout + ".txt");
    ASSERT_FALSE(golden.empty());
    const auto printed = output.document.at("output").get<std::string>();
    // Figure 15 prints two distances; the paper shows the second.
    ASSERT_GE(printed.size(), golden.size());
    EXPECT_EQ(printed.substr(printed.size() - golden.size()), golden);
    const std::size_t shown = GetParam().program == std::string("15") ? 2 : 1;
    std::size_t ends = 0;
    for (std::size_t at = printed.find(" END "); at != std::string::npos;
         at = printed.find(" END ", at + 1)) {
      ++ends;
    }
    EXPECT_EQ(ends, shown);
  }
};

TEST_P(HiroseFigures, ArePrintedByOurMacros) {
  expect_printout(run({}));
}

TEST_P(HiroseFigures, ArePrintedWithTheOriginalTouch) {
  const auto listings = original_listings();
  if (!listings) {
    GTEST_SKIP() << "the original listings are not here; G31_HIROSE names their folder";
  }
  expect_printout(run({*listings}));
}

INSTANTIATE_TEST_SUITE_P(Paper, HiroseFigures,
                         ::testing::Values(Figure{"06", "07"}, Figure{"09", "10"},
                                           Figure{"12", "13"}, Figure{"15", "16"},
                                           Figure{"18", "19"}),
                         [](const auto& figure) {
                           return std::string("figure_") + figure.param.printout;
                         });

}  // namespace
}  // namespace g31::hirose_figures_test

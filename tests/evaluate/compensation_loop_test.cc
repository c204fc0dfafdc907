// The loop with the files that a shop enters: a machine is measured, the table of its control is
// written, loaded and in force, and what is left is what lines between the points leave.

#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/evaluate/bent_slide.h"
#include "tests/support/run_evaluate.h"

namespace g31::compensation_loop_test {
namespace {

using namespace evaluate::bent_slide;  // NOLINT(google-build-using-namespace)
using evaluate::OptionId;
using testing::TemporaryFolder;

constexpr double kWritten = 1e-6;  // of a SINUMERIK's table: six decimals

/// Positions of a laser, each target twice.
std::string positions() {
  std::string text = "axis,target,direction,cycle,position\n";
  for (int x = 0; x <= kLength; x += kStep) {
    for (int cycle = 1; cycle <= 2; ++cycle) {
      text += fmt::format("X,{},1,{},{:.9f}\n", x, cycle, x + error_at(x));
    }
  }
  return text;
}

/// Sensors that ride with the machine along a straight work; Y is positive towards it.
std::string readings() {
  std::string text = "K,A,B\n";
  for (int k = 0; k * kStep <= kLength; ++k) {
    text += fmt::format("{0},{1:.12f},{1:.12f}\n", k, -error_at(k * kStep));
  }
  return text;
}

std::string table(const TemporaryFolder& folder, const std::string& kind, const char* format) {
  cli::EvaluateOptions options;
  options.kind = kind;
  if (kind == "straightness") {
    options.given[OptionId::Step] = std::to_string(kStep);
  }
  options.given[OptionId::Compensation] = folder.path("table.ini");
  options.given[OptionId::CompensationFormat] = format;
  const auto output =
      testing::evaluate_text(kind == "straightness" ? readings() : positions(), options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  return testing::text_of(folder.path("table.ini"));
}

std::vector<Beside> driven_on(const TemporaryFolder& folder,
                              const std::vector<std::string>& programs,
                              const std::string& sheet_text) {
  return driven(folder, programs, {folder.write("machine.toml", sheet_text)});
}

std::vector<std::string> sinumerik(const TemporaryFolder& folder, const std::string& enabling) {
  return {folder.write("WAY.MPF", enabling + "G94 G1 X1000 F60000\nM30\n"),
          folder.path("table.ini")};
}

TEST(CompensationLoop, SinumerikAlongTheAxis) {
  const TemporaryFolder folder;
  table(folder, "positioning", "sinumerik");
  for (const Beside& at :
       driven_on(folder, sinumerik(folder, "$MA_ENC_COMP_ENABLE[0,X]=TRUE\n"), sheet("EXX"))) {
    EXPECT_NEAR(at.dx, left_at(at.x), kTable + kWritten) << at.x;
    EXPECT_EQ(at.dy, 0.0);
  }
  for (const Beside& at : driven_on(folder, sinumerik(folder, ""), sheet("EXX"))) {
    EXPECT_NEAR(at.dx, error_at(at.x), kTable) << "a table without MD32700 does nothing";
  }
}

TEST(CompensationLoop, SinumerikAcrossTheAxis) {
  const TemporaryFolder folder;
  table(folder, "straightness", "sinumerik");
  struct Case {
    const char* enabling;
    bool counts;
  };
  const Case kCases[] = {{"$MA_CEC_ENABLE[Y]=TRUE $SN_CEC_TABLE_ENABLE[0]=TRUE\n", true},
                         {"$MA_CEC_ENABLE[Y]=TRUE\n", false},
                         {"$SN_CEC_TABLE_ENABLE[0]=TRUE\n", false},
                         {"$MA_CEC_ENABLE[X]=TRUE $SN_CEC_TABLE_ENABLE[0]=TRUE\n", false}};
  for (const Case& c : kCases) {
    for (const Beside& at : driven_on(folder, sinumerik(folder, c.enabling), sheet("EYX"))) {
      EXPECT_NEAR(at.dy, c.counts ? left_at(at.x) : error_at(at.x), kTable + kWritten) << at.x;
      EXPECT_EQ(at.dx, 0.0);
    }
  }
  for (const Beside& at :
       driven_on(folder,
                 sinumerik(folder,
                           "$SN_CEC_TABLE_WEIGHT[0]=0.5\n"
                           "$MA_CEC_ENABLE[Y]=TRUE $SN_CEC_TABLE_ENABLE[0]=TRUE\n"),
                 sheet("EYX"))) {
    EXPECT_NEAR(at.dy, 0.5 * (left_at(at.x) + error_at(at.x)), kTable + kWritten) << at.x;
  }
}

// Values of the points are whole units of 0.001 mm times the magnification, so their sum is off by
// half of one at most.
TEST(CompensationLoop, FanucPitchErrors) {
  const TemporaryFolder folder;
  const std::string text = table(folder, "positioning", "fanuc");
  const std::size_t begin = text.find("G10 L52");
  const std::string entered = text.substr(begin, text.find("G11") + 4 - begin);
  double units = 0.0;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("UNITS OF ") + 9, "%lf", &units), 1);
  ASSERT_LE(units, 2.0);
  const auto program = [&](const std::string& before) {
    return std::vector<std::string>{
        folder.write("way.nc", "%\nO1\n" + before + "G90 G21 G94\nG1 X1000. F60000.\nM30\n%\n")};
  };
  for (const Beside& at : driven_on(folder, program(entered), sheet("EXX"))) {
    EXPECT_NEAR(at.dx, left_at(at.x), kTable + 0.0005 * units + 1e-9) << at.x;
  }
  for (const Beside& at : driven_on(folder, program(""), sheet("EXX"))) {
    EXPECT_NEAR(at.dx, error_at(at.x), kTable) << at.x;
  }
}

// Corrections of 3.5 units of 100 um round to 4: two of them are a gain of 8, and there is no
// magnification above 100.
TEST(CompensationLoop, AFanucRefusesWhatItsLargestMagnificationDoesNotReach) {
  for (const auto& [deviation, exit_code] : {std::pair(0.350, 2), {0.349, 0}}) {
    const TemporaryFolder folder;
    cli::EvaluateOptions options;
    options.kind = "positioning";
    options.given[OptionId::Compensation] = folder.path("table.nc");
    options.given[OptionId::CompensationFormat] = "fanuc";
    std::string record = "axis,target,direction,cycle,position\n";
    for (int cycle = 1; cycle <= 2; ++cycle) {
      // Neighbouring points: from one to the next the correction gains twice the deviation.
      record += fmt::format("X,0,1,{0},{1:.3f}\nX,100,1,{0},{2:.3f}\n", cycle, -deviation,
                            100.0 + deviation);
    }
    const auto output = testing::evaluate_text(record, options);
    EXPECT_EQ(output.exit_code, exit_code) << output.errors;
    if (exit_code == 0) {
      EXPECT_NE(testing::text_of(folder.path("table.nc")).find("N3623 P1 R100\n"),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace g31::compensation_loop_test

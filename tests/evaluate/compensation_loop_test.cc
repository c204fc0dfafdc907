// The loop with the files that a shop enters: a machine is measured, the table of its control is
// written, loaded and in force, and what is left is what lines between the points leave.

#include <algorithm>
#include <cmath>
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

constexpr double kTraced = 1e-7;   // digits of a trace
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

// Held against the manual alone, not against what is written here: a positive value moves the axis
// in the negative direction.  Source: 6FC5397-1BP40-3BA1, K3, page 238.
TEST(CompensationLoop, APositiveValueOfASinumerikMovesBackwards) {
  const TemporaryFolder folder;
  const std::string data =
      "$AA_ENC_COMP[0,0,X]=0.003 $AA_ENC_COMP[0,1,X]=0.01 $AA_ENC_COMP_STEP[0,X]=1000\n"
      "$AA_ENC_COMP_MAX[0,X]=1000 $MA_ENC_COMP_ENABLE[0,X]=TRUE\n";
  for (const Beside& at :
       driven_on(folder, {folder.write("WAY.MPF", data + "G94 G1 X1000 F60000\nM30\n")}, "")) {
    EXPECT_NEAR(at.dx, -0.003 - 0.007 * at.x / 1000.0, kTraced) << at.x;
  }
}

// Two tables of one axis, one for the way forth and one for the way back.
TEST(CompensationLoop, SinumerikTablesOfOneDirection) {
  const TemporaryFolder folder;
  const std::string data =
      "$AN_CEC[0,0]=0.004 $AN_CEC[0,1]=0.004 $AN_CEC[1,0]=-0.004 $AN_CEC[1,1]=0.012\n"
      "$AN_CEC_STEP[0]=1000 $AN_CEC_MAX[0]=1000 $AN_CEC_STEP[1]=1000 $AN_CEC_MAX[1]=1000\n"
      "$AN_CEC_INPUT_AXIS[0]=X $AN_CEC_OUTPUT_AXIS[0]=Y $AN_CEC_DIRECTION[0]=1\n"
      "$AN_CEC_INPUT_AXIS[1]=X $AN_CEC_OUTPUT_AXIS[1]=Y $AN_CEC_DIRECTION[1]=-1\n"
      "$MA_CEC_ENABLE[Y]=TRUE $SN_CEC_TABLE_ENABLE[0]=TRUE $SN_CEC_TABLE_ENABLE[1]=TRUE\n";
  const std::vector<std::string> program = {
      folder.write("WAY.MPF", data + "G94 G1 X1000 F60000\nX0\nM30\n")};
  bool goes_back = false;
  double before = 0.0;
  int back = 0;
  for (const Beside& at : driven_on(folder, program, "")) {
    goes_back = goes_back || at.x < before - 1e-9;
    if (at.x > 0.0 && at.x < 999.0) {  // at the turn a sample may be of either way
      back += goes_back ? 1 : 0;
      // A positive value moves in the negative direction.
      EXPECT_NEAR(at.dy, goes_back ? 0.004 - 0.016 * at.x / 1000.0 : -0.004, kTraced) << at.x;
    }
    before = at.x;
  }
  EXPECT_GT(back, 50);
}

// K3's sag that depends on two axes: a table of X times one of Y; number is index + 1.
TEST(CompensationLoop, SinumerikTableTimesTable) {
  const TemporaryFolder folder;
  const std::string data =
      "$AN_CEC[0,0]=0 $AN_CEC[0,1]=0.02 $AN_CEC_STEP[0]=1000 $AN_CEC_MAX[0]=1000\n"
      "$AN_CEC[4,0]=1 $AN_CEC[4,1]=3 $AN_CEC_STEP[4]=500 $AN_CEC_MAX[4]=500\n"
      "$AN_CEC_INPUT_AXIS[0]=X $AN_CEC_OUTPUT_AXIS[0]=Y $AN_CEC_MULT_BY_TABLE[0]=5\n"
      "$AN_CEC_INPUT_AXIS[4]=X $AN_CEC_OUTPUT_AXIS[4]=Y\n"
      "$MA_CEC_ENABLE[Y]=TRUE $SN_CEC_TABLE_ENABLE[0]=TRUE\n";
  for (const Beside& at :
       driven_on(folder, {folder.write("WAY.MPF", data + "G94 G1 X1000 F60000\nM30\n")}, "")) {
    const double other = 1.0 + 2.0 * std::min(1.0, at.x / 500.0);
    EXPECT_NEAR(at.dy, -0.02 * at.x / 1000.0 * other, kTraced) << at.x;
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

/// The blocks of a table's text that a Fanuc reads.
std::string entered_by(const std::string& text) {
  const std::size_t begin = text.find("G10 L52");
  return text.substr(begin, text.find("G11") + 4 - begin);
}

/// The way along X, behind what enters a table.
std::vector<std::string> fanuc(const TemporaryFolder& folder, const std::string& before) {
  return {folder.write("way.nc", "%\nO1\n" + before + "G90 G21 G94\nG1 X1000. F60000.\nM30\n%\n")};
}

// Values of the points are whole units of 0.001 mm times the magnification, so their sum is off by
// half of one at most.
TEST(CompensationLoop, FanucPitchErrors) {
  const TemporaryFolder folder;
  const std::string text = table(folder, "positioning", "fanuc");
  double units = 0.0;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("UNITS OF ") + 9, "%lf", &units), 1);
  ASSERT_LE(units, 2.0);
  for (const Beside& at : driven_on(folder, fanuc(folder, entered_by(text)), sheet("EXX"))) {
    EXPECT_NEAR(at.dx, left_at(at.x), kTable + 0.0005 * units + 1e-9) << at.x;
  }
  for (const Beside& at : driven_on(folder, fanuc(folder, ""), sheet("EXX"))) {
    EXPECT_NEAR(at.dx, error_at(at.x), kTable) << at.x;
  }
}

/// What four places leave of the curve, by the table's own places and values.
double left_by_four(const std::string& text, double x) {
  double places[4] = {};
  double values[4] = {};
  double reference = 0.0;
  EXPECT_EQ(std::sscanf(text.c_str() + text.find("N3620 P1 R") + 10, "%lf", &reference), 1);
  for (int i = 0; i < 4; ++i) {
    const std::string point = fmt::format("N{} R", 5731 + i);
    const std::string value = fmt::format("N{} R", 5761 + i);
    EXPECT_EQ(std::sscanf(text.c_str() + text.find(point) + point.size(), "%lf", &places[i]), 1);
    EXPECT_EQ(std::sscanf(text.c_str() + text.find(value) + value.size(), "%lf", &values[i]), 1);
    places[i] = (places[i] - reference) * kStep;
  }
  int i = 0;
  while (i < 2 && x > places[i + 1]) {
    ++i;
  }
  const double share = (x - places[i]) / (places[i + 1] - places[i]);
  return error_at(x) + 0.001 * ((1.0 - share) * values[i] + share * values[i + 1]);
}

// Of the curve as it is between the points, each four places leave something; the machine then
// leaves the same, and no more than the table says of the points.
TEST(CompensationLoop, FanucStraightness) {
  const TemporaryFolder folder;
  const std::string text = table(folder, "straightness", "fanuc");
  double left_um = 0.0;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find("PLACES LEAVE ") + 13, "%lf", &left_um), 1);
  EXPECT_LT(left_um, 5.0);
  int at_points = 0;
  for (const Beside& at : driven_on(folder, fanuc(folder, entered_by(text)), sheet("EYX"))) {
    EXPECT_NEAR(at.dy, left_by_four(text, at.x), kTable + 1e-9) << at.x;
    EXPECT_EQ(at.dx, 0.0);
    if (std::abs(at.x - kStep * std::round(at.x / kStep)) < 1.0) {
      ++at_points;
      EXPECT_LE(std::abs(at.dy), 0.001 * left_um + 0.00005 + 0.0003) << at.x;
    }
  }
  EXPECT_GT(at_points, 0);
  for (const Beside& at : driven_on(folder, fanuc(folder, ""), sheet("EYX"))) {
    EXPECT_NEAR(at.dy, error_at(at.x), kTable) << at.x;
  }
}

/// Writes a Fanuc's table of a record whose rows, behind their heads, are those of one cycle: each
/// has a place for the cycle's number.
testing::EvaluateOutput entered_table(const TemporaryFolder& folder, const std::string& rows) {
  cli::EvaluateOptions options;
  options.kind = "positioning";
  options.given[OptionId::Compensation] = folder.path("table.nc");
  options.given[OptionId::CompensationFormat] = "fanuc";
  std::string record = "axis,target,direction,cycle,position\n";
  for (int cycle = 1; cycle <= 2; ++cycle) {
    record += fmt::format(fmt::runtime(rows), cycle);
  }
  return testing::evaluate_text(record, options);
}

/// Of two neighbouring places, between which the correction gains twice the deviation.
testing::EvaluateOutput steep(const TemporaryFolder& folder, double place, double way,
                              double deviation) {
  return entered_table(folder,
                       fmt::format("X,{0},1,{{0}},{1:.3f}\nX,{2},1,{{0}},{3:.3f}\n", place,
                                   place - deviation, place + way, place + way + deviation));
}

// Corrections of 3.51 units of 100 um round to 4: two of them are a gain of 8, and there is no
// magnification above 100; points half as far apart gain half as much each.
TEST(CompensationLoop, AFanucTakesPointsThatItsLargestMagnificationReaches) {
  for (const auto& [deviation, expected] :
       {std::pair(0.349, "N3623 P1 R100\nN3624 P1 R100000\n"), {0.351, "N3624 P1 R50000\n"}}) {
    const TemporaryFolder folder;
    const auto output = steep(folder, 0.0, 100.0, deviation);
    EXPECT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_NE(testing::text_of(folder.path("table.nc")).find(expected), std::string::npos)
        << deviation;
  }
}

// 900 mm from coordinate 0 the 1023 points cannot be nearer than 1 mm.
TEST(CompensationLoop, AFanucRefusesWhatItsLargestMagnificationDoesNotReach) {
  for (const auto& [deviation, exit_code] : {std::pair(0.351, 2), {0.349, 0}}) {
    const TemporaryFolder folder;
    const auto output = steep(folder, 900.0, 1.0, deviation);
    EXPECT_EQ(output.exit_code, exit_code) << output.errors;
  }
}

// What a point can gain is limited, not how far the axis is off: 2.000, 2.003 and 2.001 mm are
// gains of -3 and 2 um.
TEST(CompensationLoop, AFanucTakesALargeDeviationThatHardlyChanges) {
  const TemporaryFolder folder;
  const auto output =
      entered_table(folder, "X,0,1,{0},2.000\nX,100,1,{0},102.003\nX,200,1,{0},202.001\n");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NE(testing::text_of(folder.path("table.nc"))
                .find("N3623 P1 R1\nN3624 P1 R100000\nN10002 R-3\nN10003 R2\n"),
            std::string::npos);
  EXPECT_NE(testing::text_of(folder.path("table.nc")).find("\n(AND 2000 UM EVERYWHERE:"),
            std::string::npos);
}

}  // namespace
}  // namespace g31::compensation_loop_test

// CYCLE971 on scripted signals: where the touches are said, the results are arithmetic.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::tool_measuring_cycle_test {
namespace {

/// A cube of 25 mm, its top at X200 Y0 Z-300 of the machine; every trigger is 0.1 or 0.2 mm off.
/// Collisions on the way are not watched, so each signal is that of a touch.
constexpr const char* kSheet = R"([control]
profile = "sinumerik-828d"
[tools.5]
length = 100.2
radius = 8.1
type = 120.0
name = "MILL16"
[tools.9]
length = 100.0
radius = 5.0
type = 725.0
name = "CAL"
[machine_data]
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]" = 212.6
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]" = 187.6
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]" = 12.4
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]" = -12.6
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]" = -300.2
"$SCS_MEA_FUNCTION_MASK" = 1
[work_offsets.G54]
X = 100.0
Y = 50.0
Z = -300.0
)";

constexpr const char* kExact =
    "$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]=212.5 $SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]=187.5\n"
    "$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]=12.5 $SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]=-12.5\n"
    "$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]=-300\n";

struct Signal {
  char axis;
  double at;
};

MeasuringRun run_touches(int tool, const std::string& body, const std::vector<Signal>& signals,
                         const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  std::string sheet = signals.empty() ? "skip_signal = []\n" : "";
  for (const Signal& signal : signals) {
    sheet += fmt::format("[[skip_signal]]\naxis = \"{}\"\nat = {:.6f}\n", signal.axis, signal.at);
  }
  cli::RunOptions options;
  options.programs = {folder.write(
      "part.mpf", fmt::format("T{} M6\nG54 D1\nG0 X100 Y-50 Z160\n{}\nM30\n", tool, body))};
  options.setups = {folder.write("base.toml", kSheet), folder.write("signals.toml", sheet)};
  options.prints = names;
  return {run_program(options)};
}

void expect_touched(int tool, const std::string& body, const std::vector<Signal>& signals,
                    const std::vector<ExpectedValue>& expected) {
  std::vector<std::string> names;
  for (const ExpectedValue& row : expected) {
    names.push_back(row.name);
  }
  const MeasuringRun run = run_touches(tool, body, signals, names);
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  for (const ExpectedValue& row : expected) {
    EXPECT_NEAR(run.at(row.name), row.value, 1e-9) << row.name;
  }
}

TEST(ToolMeasuringCycle, CalibratesAllSidesOfTheToolProbe) {
  expect_touched(9, "CYCLE971(100000,0,1,0,0,0,5,2)",
                 {{'Z', -200.0},
                  {'Y', 17.5},
                  {'Y', -17.5},
                  {'X', 217.5},
                  {'X', 182.5},
                  {'Y', 17.5},
                  {'Y', -17.5}},
                 {{"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", 212.5},
                  {"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]", 187.5},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]", 12.5},
                  {"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]", -12.5},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]", -300.0},
                  {"$SNS_MEA_TP_FEED[0]", 300.0},
                  {"_OVR[8]", 212.5},
                  {"_OVR[9]", -0.1},
                  {"_OVR[14]", -12.5},
                  {"_OVR[15]", 0.1},
                  {"_OVR[16]", -300.0},
                  {"_OVR[17]", 0.2},
                  {"_OVR[28]", 2.0},
                  {"_OVI[2]", 971},
                  {"_OVI[3]", 100000},
                  {"_OVI[5]", 1},
                  {"_OVI[9]", 0},
                  {"$AA_IM[X]", 200.0},
                  {"$AA_IM[Y]", 0.0},
                  {"$AA_IM[Z]", -195.0}});
}

TEST(ToolMeasuringCycle, ADifferenceBeyondTheSafeAreaKeepsTheOldCalibration) {
  const MeasuringRun run = run_touches(9, "CYCLE971(0,0,1,3,2,0,5,0.1)", {{'Z', -200.0}},
                                       {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]", "_OVI[9]"});
  EXPECT_EQ(run.alarm(), 61303);
  EXPECT_EQ(run.at("_OVI[9]"), 61303.0);
  EXPECT_EQ(run.at("$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]"), -300.2);
}

TEST(ToolMeasuringCycle, LengthGoesIntoTheGeometryAndDeletesTheWear) {
  expect_touched(
      5, std::string(kExact) + "$TC_DP12[5,1]=0.05\nD1\nCYCLE971(1,0,1,103,2,0,5,2,,0.001,1)",
      {{'Z', -200.0}},
      {{"_OVR[8]", 100.0},
       {"_OVR[9]", -0.25},
       {"$TC_DP3[5,1]", 100.0},
       {"$TC_DP12[5,1]", 0.0},
       {"$P_TOOLL[1]", 100.0},
       {"$AA_IM[X]", 208.1},
       {"_OVI[0]", 1},
       {"_OVI[8]", 5}});
}

TEST(ToolMeasuringCycle, RadiusOfATurningToolGoesIntoTheWear) {
  expect_touched(5, std::string(kExact) + "CYCLE971(2,1,1,1,2,0,5,2,,0.001,1)\nR1=$AC_SDIR[1]",
                 {{'X', 220.5}, {'X', 220.5}},
                 {{"_OVR[10]", 8.0},
                  {"_OVR[11]", -0.1},
                  {"$TC_DP6[5,1]", 8.1},
                  {"$TC_DP15[5,1]", -0.1},
                  {"R1", 5.0}});
}

TEST(ToolMeasuringCycle, NothingIsWrittenWithoutASignal) {
  const MeasuringRun run = run_touches(5, std::string(kExact) + "CYCLE971(1,0,1,3,2,0,5,2)", {},
                                       {"$TC_DP3[5,1]", "_OVI[9]"});
  EXPECT_EQ(run.alarm(), 61301);
  EXPECT_EQ(run.at("$TC_DP3[5,1]"), 100.2);
}

}  // namespace
}  // namespace g31::testing::tool_measuring_cycle_test

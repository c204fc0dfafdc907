// CYCLE971 on a true tool probe: calibrated, then tools whose data are wrong are measured, and what
// the cycle writes is what the tools are.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"

namespace g31::testing::tool_probe_cycle_test {
namespace {

constexpr double kStanding = 1e-6;  // mm, a perfect probe
constexpr double kTurning = 1e-3;   // mm, at the cycle's own speeds

std::vector<ExpectedValue> cube_of(const std::string& set, double moved = 0.0) {
  return {{"$SNS_MEA_" + set + "_TRIG_MINUS_DIR_AX1[0]", 212.5 - moved},
          {"$SNS_MEA_" + set + "_TRIG_PLUS_DIR_AX1[0]", 187.5 - moved},
          {"$SNS_MEA_" + set + "_TRIG_MINUS_DIR_AX2[0]", 12.5 - 0.5 * moved},
          {"$SNS_MEA_" + set + "_TRIG_PLUS_DIR_AX2[0]", -12.5 - 0.5 * moved},
          {"$SNS_MEA_" + set + "_TRIG_MINUS_DIR_AX3[0]", -300.0 + 3.0 * moved},
          {"_OVI[9]", 0.0}};
}

TEST(ToolProbeCalibration, FindsTopAndSides) {
  std::vector<ExpectedValue> found = cube_of("TP");
  found.insert(found.end(), {{"_OVR[8]", 212.5},
                             {"_OVR[9]", -0.5},
                             {"_OVR[10]", 187.5},
                             {"_OVR[11]", -0.2},
                             {"_OVR[12]", 12.5},
                             {"_OVR[13]", 0.4},
                             {"_OVR[14]", -12.5},
                             {"_OVR[15]", 0.5},
                             {"_OVR[16]", -300.0},
                             {"_OVR[17]", 0.4},
                             {"_OVR[28]", 2.0},
                             {"_OVI[2]", 971.0},
                             {"$AA_IM[X]", 200.0},
                             {"$AA_IM[Y]", 0.0},
                             {"$AA_IM[Z]", -195.0}});
  expect_tools(with_tool(9) + "CYCLE971(100000,0,1,0,0,0,5,2)", {kCube}, found, kStanding);
}

TEST(ToolProbeCalibration, WithSpindleReversalAndOneAxisAfterTheOther) {
  expect_tools(with_tool(9) + "CYCLE971(1100000,0,1,0,0,0,5,2)", {kCube}, cube_of("TP"), kStanding);
  expect_tools(with_tool(9) +
                   "CYCLE971(0,0,1,3,2,0,5,2)\n"
                   "G0 SUPA Z-270\nCYCLE971(0,0,1,201,1,0,5,2)\n"
                   "G0 SUPA Z-270\nG0 SUPA X250\nCYCLE971(0,0,1,201,2,0,5,2)\n"
                   "G0 SUPA Z-270\nCYCLE971(0,0,1,102,1,0,5,2)\n"
                   "G0 SUPA Z-270\nCYCLE971(0,0,1,102,2,0,5,2)",
               {kCube}, cube_of("TP"), kStanding);
}

TEST(ToolProbeCalibration, InWorkCoordinates) {
  const std::string near =
      "[machine_data]\n\"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX1[0]\" = 112.0\n"
      "\"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX1[0]\" = 88.0\n"
      "\"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX2[0]\" = -38.0\n"
      "\"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX2[0]\" = -62.0\n"
      "\"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX3[0]\" = 0.3\n";
  expect_tools(with_tool(9) + "CYCLE971(100010,0,1,0,0,0,5,2)", {kCube, near},
               cube_of("TPW", 100.0), kStanding);
}

TEST(ToolProbeCalibration, OfADiscAndOfOnlySomeDirections) {
  const std::string disc =
      "[[tool_probe]]\nshape = \"disc\"\nsize = [25.0, 8.0]\nat = [200.0, 0.0, -300.0]\n";
  expect_tools(with_tool(9) + "CYCLE971(100000,0,1,0,0,0,5,2)", {disc}, cube_of("TP"), 1e-3);
  expect_tools(with_tool(9) + "$SNS_MEA_TP_AX_DIR_AUTO_CAL[0]=102\nCYCLE971(100000,0,1,0,0,0,5,2)",
               {kCube},
               {{"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", 213.0},
                {"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]", 187.5},
                {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]", 12.1},
                {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]", -300.0}},
               kStanding);
}

TEST(ToolProbeMeasurement, OfStandingToolsFindsTheirTrueLengthAndRadius) {
  for (const double error : {-0.5, -0.03, 0.2, 0.5}) {
    SCOPED_TRACE(error);
    const std::string wrong =
        fmt::format("$TC_DP3[5,1]={:.3f} $TC_DP6[5,1]={:.3f}\n", 100.0 + error, 8.0 - error);
    expect_tools(wrong + with_tool(5) +
                     "CYCLE971(1,0,1,103,2,0,5,2,,0.0001,1)\nR1=_OVR[8] R2=_OVR[9]\n"
                     "CYCLE971(1,0,1,103,2,0,5,2,,0.0001,1)\nR3=_OVR[9]\n"
                     "G0 SUPA Z-270\nCYCLE971(1,0,1,2,1,0,5,2,,0.0001,1)\n"
                     "G0 SUPA Z-270\nR4=_OVR[10] R5=_OVR[11]\nCYCLE971(1,0,1,1,2,0,5,2)",
                 {kCube, kKnown},
                 {{"R1", 100.0},
                  {"R2", -error},
                  {"R3", 0.0},
                  {"R4", 8.0},
                  {"R5", error},
                  {"_OVR[11]", 0.0},
                  {"$TC_DP3[5,1]", 100.0},
                  {"$TC_DP6[5,1]", 8.0},
                  {"_OVI[9]", 0.0}},
                 kStanding);
  }
}

/// The triggers are in the coordinates of G54, which is not that of the calibration in MCS.
TEST(ToolProbeMeasurement, InWorkCoordinates) {
  const std::string known =
      "[machine_data]\n\"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX1[0]\" = 112.5\n"
      "\"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX1[0]\" = 87.5\n"
      "\"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX2[0]\" = -37.5\n"
      "\"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX2[0]\" = -62.5\n"
      "\"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX3[0]\" = 0.0\n"
      "\"$SNS_MEA_TPW_EDGE_DISK_SIZE[0]\" = 25.0\n\"$SNS_MEA_TPW_FEED[0]\" = 300.0\n";
  expect_tools("$TC_DP3[5,1]=100.3 $TC_DP6[5,1]=7.8\n" + with_tool(5) +
                   "CYCLE971(11,0,1,103,2,0,5,2,,0.0001,1)\nR1=_OVR[8] R2=_OVR[9]\n"
                   "G0 SUPA Z-270\nCYCLE971(11,0,1,2,1,0,5,2,,0.0001,1)\nR3=_OVR[10] R4=_OVR[11]",
               {kCube, known},
               {{"R1", 100.0},
                {"R2", -0.3},
                {"R3", 8.0},
                {"R4", 0.2},
                {"$TC_DP3[5,1]", 100.0},
                {"$TC_DP6[5,1]", 8.0},
                {"_OVI[9]", 0.0}},
               kStanding);
}

/// Calls and results count in the program's unit; what the cycles keep is what it was in
/// millimetres.
TEST(ToolProbeMeasurement, IsTheSameInEachUnit) {
  for (const auto& [code, unit] :
       {std::pair{"G71", 1.0}, std::pair{"G70", 25.4}, std::pair{"G700", 25.4}}) {
    SCOPED_TRACE(code);
    const std::string limits = fmt::format("{:.12f},{:.12f}", 5.0 / unit, 2.0 / unit);
    const std::string tolerances = fmt::format(",,{:.12f},{:.12f}", 0.0001 / unit, 1.0 / unit);
    expect_tools(with_tool(9) + code + "\nCYCLE971(100000,0,1,0,0,0," + limits +
                     ")\nR1=_OVR[8] R2=_OVR[16]\nG710",
                 {kCube},
                 {{"R1", 212.5 / unit},
                  {"R2", -300.0 / unit},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", 212.5},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]", -300.0}},
                 kStanding);
    expect_tools(
        "$TC_DP3[5,1]=100.3 $TC_DP6[5,1]=7.8\n" + with_tool(5) + code +
            "\nCYCLE971(1,0,1,103,2,0," + limits + tolerances +
            ")\nR1=_OVR[8]\nG710 G0 SUPA Z-270\n" + code + "\nCYCLE971(1,0,1,2,1,0," + limits +
            tolerances + ")\nR2=_OVR[10]\nG710",
        {kCube, kKnown},
        {{"R1", 100.0 / unit}, {"R2", 8.0 / unit}, {"$TC_DP3[5,1]", 100.0}, {"$TC_DP6[5,1]", 8.0}},
        kStanding);
  }
}

TEST(ToolProbeMeasurement, OfADrillAndOfAMillWithTheWearCorrected) {
  expect_tools("$TC_DP3[7,1]=119.7\n" + with_tool(7, 200.0) + "CYCLE971(1,0,1,3,2,0,5,2,,0.001,1)",
               {kCube, kKnown}, {{"$TC_DP3[7,1]", 120.0}, {"_OVR[8]", 120.0}}, kStanding);
  expect_tools("$TC_DP12[5,1]=0.05 $TC_DP15[5,1]=-0.1\n" + with_tool(5) +
                   "CYCLE971(1,1,1,103,2,0,5,2,,0.001,1)\nG0 SUPA Z-270\n"
                   "CYCLE971(1,1,1,1,1,0,5,2,,0.001,1)",
               {kCube, kKnown},
               {{"$TC_DP3[5,1]", 100.0},
                {"$TC_DP12[5,1]", 0.0},
                {"$TC_DP6[5,1]", 8.0},
                {"$TC_DP15[5,1]", 0.0}},
               kStanding);
}

TEST(ToolProbeMeasurement, OfTurningToolsIsThatOfTheirLongestTooth) {
  const std::string calls =
      "CYCLE971(2,0,1,103,2,0,5,2,,0.0001,1)\nG0 SUPA Z-270\nCYCLE971(2,0,1,1,1,0,5,2,,0.0001,1)\n";
  for (const int tool : {5, 6}) {
    for (const double error : {-0.5, 0.5}) {
      SCOPED_TRACE(fmt::format("tool {} {}", tool, error));
      const std::string wrong = fmt::format(
          "$SNS_MEA_CM_MEASURING_ACCURACY[0]=0.001\n$TC_DP3[{0},1]={1:.3f} "
          "$TC_DP6[{0},1]={2:.3f}\n",
          tool, 100.0 + error, 8.0 - error);
      expect_tools(wrong + with_tool(tool) + calls + "G0 SUPA Z-270\n" + calls, {kCube, kKnown},
                   {{fmt::format("$TC_DP3[{},1]", tool), 100.0},
                    {fmt::format("$TC_DP6[{},1]", tool), 8.0},
                    {"_OVR[9]", 0.0},
                    {"_OVR[11]", 0.0}},
                   kTurning);
    }
  }
}

TEST(ToolProbeMeasurement, TurnsAsTheDataOrTheCallSay) {
  const MeasuringRun own =
      expect_tools(with_tool(5) + "CYCLE971(2,0,1,1,1,0,5,2)", {kCube, kKnown}, {}, 1.0);
  const MeasuringRun given = expect_tools(
      with_tool(5) +
          "$SNS_MEA_FUNCTION_MASK_TOOL=32\nCYCLE971(2,0,1,1,1,0,5,2,,,,,50,800,30,700,3,600)",
      {kCube, kKnown}, {}, 1.0);
  const auto feeds_of = [](const MeasuringRun& run) {
    std::vector<double> feeds;
    for (const auto& touch : run.output.document.at("touches")) {
      if (touch.value("triggered", false)) {
        feeds.push_back(touch.at("feed").get<double>());
      }
    }
    return feeds;
  };
  // r 8 mm: 1000 rev/min and 5 mm/min; ten times that is limited to 20, the last at half of it.
  EXPECT_EQ(feeds_of(own), (std::vector<double>{20.0, 2.5}));
  EXPECT_EQ(feeds_of(given), (std::vector<double>{50.0, 30.0, 3.0}));
}

TEST(ToolProbeMeasurement, WithAnEmpiricalValueInInchesAndIncrementally) {
  const std::string wrong = "$TC_DP3[5,1]=100.5\n";
  expect_tools(wrong + "$SCS_MEA_EMPIRIC_VALUE[1]=0.05\n" + with_tool(5) +
                   "CYCLE971(1,0,1,103,2,0,5,2,,0.001,1,,,,,,,,2)",
               {kCube, kKnown},
               {{"$TC_DP3[5,1]", 99.95}, {"_OVR[9]", -0.5}, {"_OVR[30]", 0.05}, {"_OVI[7]", 2.0}},
               kStanding);
  expect_tools(wrong + with_tool(5) + "G70\nCYCLE971(1,0,1,103,2,0,0.2,0.1,,0.00001,0.05)\nG71",
               {kCube, kKnown},
               {{"$TC_DP3[5,1]", 100.0},
                {"_OVR[8]", 100.0 / 25.4},
                {"_OVR[9]", -0.5 / 25.4},
                {"_OVR[28]", 0.1}},
               kStanding);
  expect_tools(wrong + with_tool(5) +
                   "G0 SUPA X200\nG0 SUPA Z-296\nCYCLE971(10001,0,1,3,2,0,5,1)\nR1=$AA_IM[Z]",
               {kCube, kKnown}, {{"$TC_DP3[5,1]", 100.0}, {"R1", -195.5}}, kStanding);
}

TEST(ToolProbeMeasurement, LeavesTheSpindleAsItWas) {
  expect_tools(with_tool(5) +
                   "S300 M3\nCYCLE971(2,0,1,1,1,0,5,2)\nR1=$AC_SDIR[1] R2=$AA_S[1]\n"
                   "M5\nG0 SUPA Z-270\nCYCLE971(2,0,1,1,1,0,5,2)\nR3=$AC_SDIR[1]",
               {kCube, kKnown}, {{"R1", 3.0}, {"R2", 300.0}, {"R3", 5.0}}, 1e-9);
}

std::size_t signals_of(const MeasuringRun& run) {
  std::size_t count = 0;
  for (const auto& touch : run.output.document.at("touches")) {
    count += touch.value("triggered", false) ? 1U : 0U;
  }
  return count;
}

TEST(ToolProbeMeasurement, IsRepeatedAndGoesOnWithoutAnAlarmWhereTheDataSaySo) {
  const std::string broken = "$TC_DP3[5,1]=102\n" + with_tool(5);
  const std::string call = "CYCLE971(1,0,1,103,2,0,5,1)\nR1=1";
  const MeasuringRun once = run_tools(broken + call, {kCube, kKnown}, {});
  const MeasuringRun twice =
      run_tools(broken + "$SNS_MEA_FUNCTION_MASK=65536+8\n" + call, {kCube, kKnown}, {});
  const MeasuringRun earlier = run_tools(broken + "_CBIT[0]=1\n" + call, {kCube, kKnown}, {});
  const MeasuringRun hidden = run_tools(broken + "$SNS_MEA_ALARM_MASK=196608\n" + call,
                                        {kCube, kKnown}, {"R1", "_OVI[9]", "$TC_DP3[5,1]"});
  EXPECT_EQ(once.alarm(), 61303);
  EXPECT_EQ(signals_of(once), 1U);
  EXPECT_EQ(twice.alarm(), 61303);
  EXPECT_EQ(signals_of(twice), 2U);
  EXPECT_EQ(signals_of(earlier), 2U);
  EXPECT_EQ(hidden.alarm(), 0) << hidden.output.errors;
  EXPECT_EQ(hidden.at("R1"), 1.0);
  EXPECT_EQ(hidden.at("_OVI[9]"), 61303.0);
  EXPECT_EQ(hidden.at("$TC_DP3[5,1]"), 102.0);
}

TEST(ToolProbeMeasurement, OfTeethOneByOne) {
  expect_tools("$TC_DPNT[6,1]=4\n$TC_DP6[6,1]=8.1 $TC_DP3[6,1]=100.1\n" + with_tool(6) +
                   "CYCLE971(102,0,1,1,1,0,5,2,,0.001,0.5)\nG0 SUPA Z-270\n"
                   "CYCLE971(102,0,1,103,2,0,5,2,,0.001,0.5,,,,,,,,,,,1000*2)",
               {kCube, kKnown},
               {{"$TC_DP6[6,1]", 8.0},
                {"_OVR[10]", 8.0},
                {"_OVR[14]", 7.97},
                {"$TC_DP3[6,1]", 100.0},
                {"_OVR[8]", 100.0},
                {"_OVR[12]", 99.97},
                {"_OVI[9]", 0.0}},
               1e-4);
}

TEST(ToolSetterProgram, FindsTheTrueMillTeethAndAll) {
  cli::RunOptions options;
  options.programs = {"parts/library/tool_setter/measure_tools.mpf"};
  options.setups = {"parts/library/tool_setter/setter.toml"};
  options.prints = {"$TC_DP3[5,1]", "$TC_DP6[5,1]", "_OVR[10]", "_OVR[14]"};
  const MeasuringRun run{run_program(options)};
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  EXPECT_NEAR(run.at("$TC_DP3[5,1]"), 100.0, kTurning);
  EXPECT_NEAR(run.at("$TC_DP6[5,1]"), 8.0, kTurning);
  EXPECT_NEAR(run.at("_OVR[10]"), 8.0, 1e-4);
  EXPECT_NEAR(run.at("_OVR[14]"), 7.985, 1e-4);
}

}  // namespace
}  // namespace g31::testing::tool_probe_cycle_test
